// What a page around the viewer can ask of it and is told, by postMessage. This is its contract (assets/docs/viewer.md).
import type { Facts } from './stage.ts';

/** From the page around it. Angles in degrees from the front: yaw to the right, pitch from above. */
export type Wish =
  | { type: 'spineloft:show'; text: string }
  | { type: 'spineloft:show'; glb: ArrayBuffer; name?: string }
  | { type: 'spineloft:look'; yaw: number; pitch: number }
  | { type: 'spineloft:turn'; on: boolean };

/** To the page around it. */
export type News =
  | { type: 'spineloft:ready' }
  | ({ type: 'spineloft:shown'; name: string } & Facts)
  | { type: 'spineloft:failed'; code: string; sentence: string };

/** Largest GLB that is taken. */
const kMostBytes = 256 * 1024 * 1024;
/** Longest share text that the engine reads (io/share_text.h). */
const kMostText = 1_048_576;

/** The wish in a message; null when there is none in it. */
export function wishOf(data: unknown): Wish | null {
  const wish = data as Partial<Record<string, unknown>> | null;
  if (typeof wish !== 'object' || wish === null) return null;
  const { type, text, glb, name, yaw, pitch, on } = wish;
  if (type === 'spineloft:look' && Number.isFinite(yaw) && Number.isFinite(pitch))
    return { type, yaw: yaw as number, pitch: pitch as number };
  if (type === 'spineloft:turn' && typeof on === 'boolean') return { type, on };
  if (type !== 'spineloft:show') return null;
  if (typeof text === 'string' && text.length <= kMostText) return { type, text };
  if (glb instanceof ArrayBuffer && glb.byteLength <= kMostBytes)
    return { type, glb, ...(typeof name === 'string' ? { name } : {}) };
  return null;
}
