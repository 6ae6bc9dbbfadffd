// Failures with a sentence for a person and a code for a program.
import type { SpineLoftFailure } from './api.ts';
import { t } from './words/words.ts';

const kName = 'SpineLoftError';

/** An expected failure; its message is the sentence that a toast shows. */
export class Failure extends Error implements SpineLoftFailure {
  readonly code: string;
  constructor(code: string, sentence: string) {
    super(sentence);
    this.name = kName;
    this.code = code;
  }
}

/** Whether it is a Failure, also one of a module that was bundled apart and has a class of its own. */
export function isFailure(thrown: unknown): thrown is Failure {
  return thrown instanceof Error && thrown.name === kName && 'code' in thrown;
}

/** Anything that was thrown, in words for a toast. */
export function sentenceOf(thrown: unknown): string {
  if (isFailure(thrown)) return thrown.message;
  const text = thrown instanceof Error ? thrown.message : String(thrown);
  return t('Something went wrong in the page ({text}). Your work is kept; try again.', { text });
}
