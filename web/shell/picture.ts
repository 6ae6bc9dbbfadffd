// From a file to the working copy the engine wants: the engine reads the header, the browser decodes with the EXIF turn
// applied, and the picture is scaled down to at most the pixels that the engine works on.
import { Failure } from './failure.ts';

/** The engine's limits (engine/base/limits.h). */
export interface PictureLimits {
  minSide: number;
  maxSide: number;
  mostPixels: number;
  workingPixels: number;
}

/** What the engine says of a file: its format and the limits, or the error that it is refused with. */
export type Probe = { error: string } | ({ error?: undefined; format: string } & PictureLimits);

/** Who reads headers and knows the sentences of errors, by name. */
export interface PictureReader {
  probe(bytes: Uint8Array): Probe;
  sentence(code: string): string;
}

export interface WorkingCopy {
  /** RGBA, not premultiplied, rows from the top. */
  rgba: Uint8ClampedArray;
  width: number;
  height: number;
  originalWidth: number;
  originalHeight: number;
}

const kHeicSentence = 'This browser cannot open HEIC photos. Save or share the photo as a JPEG and choose that.';

/** The error name a size deserves, or null when it is fine. */
export function sizeError(width: number, height: number, limits: PictureLimits): string | null {
  if (width === 0 || height === 0) return 'PictureEmpty';
  if (Math.max(width, height) > limits.maxSide || width * height > limits.mostPixels) return 'PictureTooLarge';
  if (Math.min(width, height) < limits.minSide) return 'PictureTooSmall';
  return null;
}

/** Size of the working copy: at most `pixels`, same shape, at least one pixel a side. */
export function workingSize(width: number, height: number, pixels: number): { width: number; height: number } {
  const scale = Math.min(1, Math.sqrt(pixels / (width * height)));
  return {
    width: Math.max(1, Math.floor(width * scale)),
    height: Math.max(1, Math.floor(height * scale)),
  };
}

/** Decodes a picture file. Rejects with PictureEmpty, PictureUnreadable, PictureTruncated, PictureTooSmall or PictureTooLarge. */
export async function decodePicture(file: Blob, reader: PictureReader): Promise<WorkingCopy> {
  const fail = (code: string, sentence = reader.sentence(code)) => new Failure(code, sentence);
  if (file.size === 0) throw fail('PictureEmpty');
  const bytes = await readBytes(file).catch(() => {
    throw fail('FileUnreadable');
  });
  const probe = reader.probe(bytes);
  if (probe.error !== undefined) throw fail(probe.error);
  const bitmap = await createImageBitmap(new Blob([bytes as BlobPart]), {
    imageOrientation: 'from-image',
    premultiplyAlpha: 'none',
  }).catch(() => {
    throw probe.format === 'heic' ? fail('PictureUnreadable', kHeicSentence) : fail('PictureTruncated');
  });
  try {
    const error = sizeError(bitmap.width, bitmap.height, probe);
    if (error) throw fail(error);
    return scaleDown(bitmap, probe.workingPixels);
  } finally {
    bitmap.close();
  }
}

async function readBytes(file: Blob): Promise<Uint8Array> {
  return new Uint8Array(await file.arrayBuffer());
}

function scaleDown(bitmap: ImageBitmap, pixels: number): WorkingCopy {
  const size = workingSize(bitmap.width, bitmap.height, pixels);
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
