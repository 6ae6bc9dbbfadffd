// What the page and the worker that cuts out tell each other.
import type { LifeMessage } from '../live_worker.ts';

/** A picture of the engine: RGBA pixels of its working copy, and the size of the original. */
export interface CutPicture {
  width: number;
  height: number;
  originalWidth: number;
  originalHeight: number;
  rgba: Uint8Array;
}

export interface CutRequest {
  id: number;
  /** As the engine writes them (engine/vision/cut_out_numbers.h). */
  hints: Float64Array;
  /** null: the one of the last request. */
  picture: CutPicture | null;
}

/** Nobody waits for what was asked for. */
export interface CutStop {
  stop: true;
}

export type CutMessage =
  | LifeMessage
  /** `done`: 0…1 of the rounds. */
  | { type: 'progress'; id: number; done: number }
  /** What was found as the engine reads it; `bytes`: what the program's memory has grown to. */
  | { type: 'found'; id: number; found: Float64Array; bytes: number };
