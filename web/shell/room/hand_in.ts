// What a pupil hands in: the model as files, and its pictures all the way round for the wall.
import { canvasFile } from '../canvas_file.ts';
import type { Engine } from '../engine.ts';
import { Failure } from '../failure.ts';
import { pngOf } from '../turntable.ts';
import { serverSide } from './host.ts';

export interface HandIn {
  name: string;
  /** The link's text; empty where it is too long for a QR code that is easily read. */
  text: string;
  frames: number;
  pictures: Uint8Array;
  /** A ZIP: model.glb, model.3mf where there is one, picture.png. */
  files: Uint8Array;
}

/** Pictures on the wall: so many round the model, each so large. */
export const kFrames = 12,
  kFrameSide = 160;
const kPictureSide = 640,
  kQuality = 0.82,
  kMostText = 1200;
/** The server takes 8 MB, and encryption adds a little. */
const kMostBytes = 8_000_000;

/** The model turning round, side by side: as WebP, or where the browser does not write it as JPEG on white. */
async function picturesOf(engine: Engine): Promise<Uint8Array> {
  const canvas = document.createElement('canvas');
  canvas.width = kFrames * kFrameSide;
  canvas.height = kFrameSide;
  const context = canvas.getContext('2d')!;
  for (let i = 0; i < kFrames; i += 1) {
    const rgba = engine.turntable(kFrameSide, kFrameSide, i / kFrames);
    if (!rgba) throw nothingYet();
    context.putImageData(new ImageData(new Uint8ClampedArray(rgba), kFrameSide, kFrameSide), i * kFrameSide, 0);
  }
  return canvasFile(canvas, kQuality);
}

const nothingYet = () =>
  new Failure('NothingToExport', 'There is nothing to hand in yet. Draw a line through something first.');

export async function handInOf(engine: Engine): Promise<HandIn> {
  const api = window.spineloft;
  await api.idle();
  if (api.state().parts.length === 0) throw nothingYet();
  const { zipSync } = await serverSide();
  const glb = await api.exportModel('glb');
  // A model that cannot be printed yet is handed in all the same.
  const print = await api.exportModel('3mf').catch(() => null);
  const picture = await pngOf(engine, kPictureSide);
  const files = (withPrint: boolean) =>
    zipSync({
      'model.glb': glb,
      ...(print && withPrint ? { 'model.3mf': [print, { level: 0 }] as const } : {}),
      ...(picture ? { 'picture.png': [picture, { level: 0 }] as const } : {}),
    } as Parameters<typeof zipSync>[0]);
  let zip = files(true);
  if (zip.length > kMostBytes) zip = files(false);
  if (zip.length > kMostBytes)
    throw new Failure('TooLarge', 'This model is too large to hand in. Save a file, and give that.');
  let text = '';
  try {
    text = engine.shareText({}).text;
  } catch {
    // It has no link then.
  }
  return {
    name: engine.about().name,
    text: text.length <= kMostText ? text : '',
    frames: kFrames,
    pictures: await picturesOf(engine),
    files: zip,
  };
}
