// The short links that were made in this browser, with the secrets that take them back.
import type { StoredModel } from './client.ts';

/** A link that was made here. */
export interface MadeLink extends StoredModel {
  name: string;
  url: string;
  /** When it expires, in milliseconds since 1970. */
  until: number;
}

const kKey = 'spineloft.stored.1';
/** What a browser that keeps nothing knows until the page is closed. */
let unkept: MadeLink[] = [];

/** Those that have not expired, the first made first. */
export function madeLinks(): MadeLink[] {
  let kept: MadeLink[] = [];
  try {
    kept = JSON.parse(localStorage.getItem(kKey) ?? '[]') as MadeLink[];
  } catch {
    // Blocked, or not ours.
  }
  const others = unkept.filter(({ id }) => !kept.some((one) => one.id === id));
  return [...kept, ...others].filter(({ until }) => until > Date.now());
}

export function keepLinks(links: MadeLink[]): void {
  try {
    localStorage.setItem(kKey, JSON.stringify(links));
    unkept = [];
  } catch {
    unkept = links;
  }
}
