// Failures with a sentence for a person and a code for a program.
import type { SpineLoftFailure } from './api.ts';
import { t } from './words/words.ts';

/** An expected failure; its message is the sentence that a toast shows. */
export class Failure extends Error implements SpineLoftFailure {
  readonly code: string;
  constructor(code: string, sentence: string) {
    super(sentence);
    this.name = 'SpineLoftError';
    this.code = code;
  }
}

/** Anything that was thrown, in words for a toast. */
export function sentenceOf(thrown: unknown): string {
  if (thrown instanceof Failure) return thrown.message;
  const text = thrown instanceof Error ? thrown.message : String(thrown);
  return t('Something went wrong in the page ({text}). Your work is kept; try again.', { text });
}
