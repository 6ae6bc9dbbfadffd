import type { SolidFailure } from './protocol.ts';

/** A request cannot be solved further; nothing is broken. */
export class Unsolvable extends Error {
  constructor(readonly failure: SolidFailure) {
    super(failure.error);
  }
}
