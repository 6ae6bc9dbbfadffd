// Small pictures of models for the list.
import type { Thumbnail } from './store.ts';

const kQuality = 0.82;

/** RGBA pixels as a small file: WebP, or PNG where the browser cannot write it. */
export async function shrunkPicture(
  rgba: Uint8ClampedArray,
  size: { width: number; height: number },
): Promise<Thumbnail> {
  const canvas = document.createElement('canvas');
  canvas.width = size.width;
  canvas.height = size.height;
  canvas.getContext('2d')?.putImageData(new ImageData(new Uint8ClampedArray(rgba), size.width, size.height), 0, 0);
  const blob = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, 'image/webp', kQuality));
  if (!blob) throw new Error('the thumbnail could not be written');
  return { type: blob.type, bytes: new Uint8Array(await blob.arrayBuffer()) };
}
