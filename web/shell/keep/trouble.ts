// What can go wrong with keeping models, in plain words.

export type StoreTrouble = 'missing' | 'silent' | 'newer' | 'full' | 'failed' | 'taken' | 'photo-missing';

/** Sentences for people: what happened and what to do. */
const kSentences: Record<StoreTrouble, string> = {
  missing:
    'This browser does not let the page keep your models (a private window, or blocked site data). Save a file before you close it.',
  silent:
    'The storage of this browser does not answer, so your models are not kept. Save a file before you close the page, or restart the browser.',
  newer:
    'The models on this device were kept by a newer SpineLoft. Load the page again to get it; until then save a file before you close it.',
  full: 'There is no room left on this device to keep your work. Save a file, or delete old models.',
  failed: 'Your work cannot be kept on this device right now. Save a file before you close the page.',
  taken: 'This model is open in another tab now. Changes here are not kept.',
  'photo-missing': 'A picture of this model is missing on this device.',
};

/** A failure of the model store. */
export class StoreFailure extends Error {
  constructor(
    readonly code: StoreTrouble,
    cause?: unknown,
  ) {
    super(kSentences[code], { cause });
    this.name = 'StoreFailure';
  }
}

function nameOf(thrown: unknown): string {
  return thrown !== null && typeof thrown === 'object' && 'name' in thrown ? String(thrown.name) : '';
}

/** Whatever IndexedDB throws as one of our troubles. */
export function storeFailureOf(thrown: unknown): StoreFailure {
  if (thrown instanceof StoreFailure) return thrown;
  switch (nameOf(thrown)) {
    case 'QuotaExceededError':
      return new StoreFailure('full', thrown);
    case 'VersionError':
      return new StoreFailure('newer', thrown);
    case 'SecurityError':
    case 'NotAllowedError':
    case 'InvalidAccessError':
      return new StoreFailure('missing', thrown);
    default:
      return new StoreFailure('failed', thrown);
  }
}
