// Keys to the engine, unless a text field, an open menu or a dialog wants them.
import type { Engine } from './engine.ts';
import type { KeyboardPen } from './keyboard_pen.ts';

export interface ModifierKeys {
  shiftKey: boolean;
  ctrlKey: boolean;
  altKey: boolean;
  metaKey: boolean;
}

/** 1 shift, 2 ctrl, 4 alt, 8 meta. */
export function modifiersOf(event: ModifierKeys): number {
  return (event.shiftKey ? 1 : 0) | (event.ctrlKey ? 2 : 0) | (event.altKey ? 4 : 0) | (event.metaKey ? 8 : 0);
}

/** True where typing belongs to the element and not to the drawing. */
export function isTextField(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.isContentEditable || target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement)
    return true;
  return target instanceof HTMLInputElement && !['button', 'checkbox', 'radio', 'file', 'submit'].includes(target.type);
}

/** Buttons, links, menus and dialogs keep the keys that work them; a plain key elsewhere is a shortcut. */
function belongsToElement(event: KeyboardEvent): boolean {
  const target = event.target;
  if (isTextField(target)) return true;
  if (!(target instanceof Element)) return false;
  if (target.closest('dialog, [role="menu"]')) return true;
  const worked = target.closest('button, a, [role="button"]') !== null;
  return worked && ['Enter', ' ', 'ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', 'Home', 'End'].includes(event.key);
}

export interface KeyboardPage {
  engine: Engine;
  pen: KeyboardPen;
  /** Opens a dialog that is about no model. */
  show(dialog: 'help' | 'find-command'): void;
  /** True while shortcuts of the drawing make no sense (start page). */
  isQuiet(): boolean;
  /** True while nothing can be changed here: the model is open in another tab. */
  isLocked(): boolean;
}

/** Keys that count everywhere, on the start page and where nothing can be changed. */
const kEverywhere = { '?': 'help', '/': 'find-command' } as const;

/** Listens on the window; Tab is never taken, so focus always moves on. */
export function connectKeyboard(page: KeyboardPage): void {
  const listen = (event: KeyboardEvent, down: boolean) => {
    if (event.key === 'Tab' || event.isComposing || event.defaultPrevented || belongsToElement(event)) return;
    const dialog = kEverywhere[event.key as keyof typeof kEverywhere];
    if (down && dialog && !event.ctrlKey && !event.metaKey) {
      event.preventDefault();
      page.show(dialog);
      return;
    }
    if (page.isLocked()) return;
    // A pen that is out has its keys first. It comes by Enter, unless that ends what is open.
    if (down && page.pen.isOut && page.pen.key(event)) {
      event.preventDefault();
      return;
    }
    const plain = !event.ctrlKey && !event.metaKey;
    if (page.isQuiet() && plain) return;
    const used = page.engine.key(event.code, event.key, down, modifiersOf(event)) || (down && page.pen.key(event));
    if (used) event.preventDefault();
  };
  window.addEventListener('keydown', (event) => listen(event, true));
  window.addEventListener('keyup', (event) => listen(event, false));
}
