// Photos in links: small copies, as files that browsers write and read.
import { base64url, fromBase64url } from './base64.ts';
import { canvasFile } from './canvas_file.ts';
import type { Engine } from './engine.ts';
import type { RawPhoto } from './keep/pack.ts';
import { decodePicture } from './picture.ts';

/** Longest side of a copy in pixels (engine/io/share_text.h), and how well a browser is to keep it. */
const kSide = 512,
  kQuality = 0.6;

function smaller({ width, height, rgba }: RawPhoto): HTMLCanvasElement {
  const whole = document.createElement('canvas'),
    small = document.createElement('canvas');
  whole.width = width;
  whole.height = height;
  whole.getContext('2d')!.putImageData(new ImageData(new Uint8ClampedArray(rgba), width, height), 0, 0);
  const scale = Math.min(1, kSide / Math.max(width, height));
  small.width = Math.max(1, Math.round(width * scale));
  small.height = Math.max(1, Math.round(height * scale));
  const context = small.getContext('2d')!;
  context.imageSmoothingQuality = 'high';
  context.drawImage(whole, 0, 0, small.width, small.height);
  return small;
}

/** Copies of the photos of the model by their content hashes, as `Engine.shareText` takes them. */
export async function photoCopies(engine: Engine): Promise<Record<string, string>> {
  const copies: Record<string, string> = {};
  for (const hash of engine.photos()) {
    const photo = engine.photo(hash);
    if (photo) copies[hash] = base64url(await canvasFile(smaller(photo), kQuality));
  }
  return copies;
}

/** The photos in a link by their pictures; none in a project file. What the browser cannot decode is left out. */
export async function photosIn(engine: Engine, link: Uint8Array): Promise<Record<string, RawPhoto>> {
  const photos: Record<string, RawPhoto> = {};
  for (const [picture, copy] of Object.entries(engine.photosOfLink(link))) {
    try {
      const { rgba, ...about } = await decodePicture(new Blob([fromBase64url(copy)]), engine);
      photos[picture] = { hash: '', ...about, rgba: new Uint8Array(rgba) };
    } catch (thrown) {
      console.warn(thrown);
    }
  }
  return photos;
}
