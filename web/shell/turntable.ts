// The model turning round, as pictures to show: one PNG, or a short GIF that goes round for ever.
import { GIFEncoder, applyPalette, quantize } from 'gifenc';

/** What the engine asks for. */
export interface TurntableEvent {
  type: 'turntable';
  what: 'png' | 'gif';
  /** File name without its ending. */
  name: string;
}

/** Who draws: RGBA pixels of the model turned by `turn` (0…1 of the way round), null when there is nothing to show. */
export interface Turnable {
  turntable(width: number, height: number, turn: number): Uint8ClampedArray | null;
}

/** Who puts the model into a PNG, too. */
export interface PictureMaker extends Turnable {
  pictureWithModel(png: Uint8Array): Uint8Array;
}

/** Sides of the pictures in pixels, and how the GIF goes round. */
export const kPngSide = 1024,
  kGifSide = 320,
  kFrames = 30,
  kFrameMs = 100;
const kColours = 256;

/** The model from home on a canvas of its own; null when there is nothing to show. */
export function stillOf(engine: Turnable, side: number): HTMLCanvasElement | null {
  const rgba = engine.turntable(side, side, 0);
  if (!rgba) return null;
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = side;
  canvas.getContext('2d')?.putImageData(new ImageData(new Uint8ClampedArray(rgba), side, side), 0, 0);
  return canvas;
}

/** One picture as PNG with the model inside; null when there is nothing to show. */
export async function pngOf(engine: PictureMaker, side = kPngSide): Promise<Uint8Array | null> {
  const canvas = stillOf(engine, side);
  if (!canvas) return null;
  const blob = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, 'image/png'));
  if (!blob) throw new Error('the picture could not be written');
  return engine.pictureWithModel(new Uint8Array(await blob.arrayBuffer()));
}

/**
 * All frames as a GIF. The page lives on between two frames; `shown` is told the share that is done and says
 * whether to go on. Null when there is nothing to show, or no more wish for it.
 */
export async function gifOf(
  engine: Turnable,
  shown: (done: number) => boolean,
  frames = kFrames,
): Promise<Uint8Array | null> {
  const gif = GIFEncoder();
  for (let i = 0; i < frames; ++i) {
    const rgba = engine.turntable(kGifSide, kGifSide, i / frames);
    if (!rgba) return null;
    const palette = quantize(rgba, kColours);
    gif.writeFrame(applyPalette(rgba, palette), kGifSide, kGifSide, { palette, delay: kFrameMs, repeat: 0 });
    if (!shown((i + 1) / frames)) return null;
    await new Promise((resolve) => setTimeout(resolve));
  }
  gif.finish();
  return gif.bytes();
}
