// The shelf of slices that a visitor drew: kept in this browser, for every model and visit. The engine checks what is read;
// where storage is blocked or full the shelf works for this visit.
import { toast } from './toasts.ts';

const kKey = 'spineloft.shelf.1';
/** More text than this is not ours. */
const kMostText = 4_000_000;

let warned = false;

function parse(text: string | null): unknown[] {
  if (text === null || text.length > kMostText) return [];
  try {
    const slices: unknown = JSON.parse(text);
    return Array.isArray(slices) ? slices : [];
  } catch {
    return [];
  }
}

/** What the browser keeps; empty when there is nothing, or no storage. */
export function readShelf(): unknown[] {
  try {
    return parse(localStorage.getItem(kKey));
  } catch {
    return []; // blocked
  }
}

/** Keeps the shelf as it is now; says once when that is not possible. */
export function keepShelf(slices: unknown[]): void {
  try {
    localStorage.setItem(kKey, JSON.stringify(slices));
  } catch {
    if (!warned) toast('This browser does not let the page keep your slices: they stay until you close it.', 'hint');
    warned = true;
  }
}

/** Follows the shelf when another tab changes it. */
export function watchShelf(onChange: (slices: unknown[]) => void): void {
  window.addEventListener('storage', (event) => {
    if (event.key === kKey) onChange(parse(event.newValue));
  });
}
