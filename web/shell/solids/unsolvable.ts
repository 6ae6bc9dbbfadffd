import type { SolidFailure } from './protocol.ts';

/** A request cannot be solved further; nothing is broken. */
export class Unsolvable extends Error {
  constructor(readonly failure: SolidFailure) {
    super(failure.error);
  }
}

/** What a step that threw this says. */
export function failureOf(thrown: unknown): SolidFailure {
  // The library's memory is not to be trusted after that: its worker has to end.
  if (thrown instanceof WebAssembly.RuntimeError) throw thrown;
  if (thrown instanceof Unsolvable) return thrown.failure;
  return { error: thrown instanceof RangeError ? 'OutOfMemory' : 'SolidFailed' };
}
