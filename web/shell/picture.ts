// From a file to the working copy the engine wants: probe, decode with the EXIF turn applied,
// scale down to at most kWorkingPixels.
import { Failure } from './failure.ts';
import { probePicture } from './probe.ts';

/** The engine's limits (engine/base/limits.h). */
const kMinPictureSide = 16;
const kMaxPictureSide = 32768;
const kMaxPicturePixels = 120_000_000;
const kWorkingPixels = 4_000_000;

export interface WorkingCopy {
  /** RGBA, not premultiplied, rows from the top. */
  rgba: Uint8ClampedArray;
  width: number;
  height: number;
  originalWidth: number;
  originalHeight: number;
}

/** The engine's sentence for one of its errors, by name. */
export type SentenceOf = (code: string) => string;

const kHeicSentence = 'This browser cannot open HEIC photos. Save or share the photo as a JPEG and choose that.';

/** The error name a size deserves, or null when it is fine. */
export function sizeError(width: number, height: number): string | null {
  if (width === 0 || height === 0) return 'PictureEmpty';
  if (Math.max(width, height) > kMaxPictureSide || width * height > kMaxPicturePixels) return 'PictureTooLarge';
  if (Math.min(width, height) < kMinPictureSide) return 'PictureTooSmall';
  return null;
}

/** Size of the working copy: at most `pixels`, same shape, at least one pixel a side. */
export function workingSize(width: number, height: number, pixels = kWorkingPixels): { width: number; height: number } {
  const scale = Math.min(1, Math.sqrt(pixels / (width * height)));
  return {
    width: Math.max(1, Math.floor(width * scale)),
    height: Math.max(1, Math.floor(height * scale)),
  };
}

/** Decodes a picture file. Rejects with PictureEmpty, PictureUnreadable, PictureTruncated, PictureTooSmall or PictureTooLarge. */
export async function decodePicture(file: Blob, sentenceOf: SentenceOf): Promise<WorkingCopy> {
  const fail = (code: string, sentence = sentenceOf(code)) => new Failure(code, sentence);
  if (file.size === 0) throw fail('PictureEmpty');
  const bytes = await readBytes(file).catch(() => {
    throw fail('FileUnreadable');
  });
  const probe = probePicture(bytes);
  if (!probe) throw fail('PictureUnreadable');
  if (probe.width !== null && probe.height !== null) {
    const error = sizeError(probe.width, probe.height);
    if (error) throw fail(error);
  }
  if (!probe.complete) throw fail('PictureTruncated');
  const bitmap = await createImageBitmap(new Blob([bytes as BlobPart]), {
    imageOrientation: 'from-image',
    premultiplyAlpha: 'none',
  }).catch(() => {
    throw probe.format === 'heic' ? fail('PictureUnreadable', kHeicSentence) : fail('PictureTruncated');
  });
  try {
    const error = sizeError(bitmap.width, bitmap.height);
    if (error) throw fail(error);
    return scaleDown(bitmap);
  } finally {
    bitmap.close();
  }
}

async function readBytes(file: Blob): Promise<Uint8Array> {
  return new Uint8Array(await file.arrayBuffer());
}

function scaleDown(bitmap: ImageBitmap): WorkingCopy {
  const size = workingSize(bitmap.width, bitmap.height);
  const canvas = document.createElement('canvas');
  canvas.width = size.width;
  canvas.height = size.height;
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (!context) throw new Failure('OutOfMemory', 'There is not enough memory to open this picture.');
  context.imageSmoothingEnabled = size.width !== bitmap.width;
  context.imageSmoothingQuality = 'high';
  context.drawImage(bitmap, 0, 0, size.width, size.height);
  const { data } = context.getImageData(0, 0, size.width, size.height);
  return { rgba: data, ...size, originalWidth: bitmap.width, originalHeight: bitmap.height };
}
