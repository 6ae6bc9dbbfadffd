// Small helpers around the DOM.

/** The element with this id; the page's own markup guarantees it. */
export function byId<T extends HTMLElement = HTMLElement>(id: string): T {
  const element = document.getElementById(id);
  if (!element) throw new Error(`index.html lacks #${id}`);
  return element as T;
}

type Attributes = Record<string, string | boolean | undefined>;

/** A new element: attributes (false and undefined are left out, true is empty) and children. */
export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === false) continue;
    element.setAttribute(name, value === true ? '' : value);
  }
  element.append(...children);
  return element;
}

/** Sets or removes an attribute, touching the DOM only when it differs. */
export function setAttribute(element: Element, name: string, value: string | null): void {
  if (element.getAttribute(name) === value) return;
  if (value === null) element.removeAttribute(name);
  else element.setAttribute(name, value);
}

export const kIsMac = /Mac|iPhone|iPad/.test(navigator.platform);

/** The first of the shortcuts of a command ("Delete, Backspace"). */
export function firstShortcut(shortcuts: string): string {
  return shortcuts.split(/,\s*/)[0] ?? '';
}

/** "Ctrl+Z" as this machine's keyboard says it. */
export function shortcutText(shortcut: string): string {
  if (!kIsMac) return shortcut;
  return shortcut.replaceAll('Ctrl+', '⌘').replaceAll('Shift+', '⇧').replaceAll('Alt+', '⌥');
}

/** The same in the form of aria-keyshortcuts. */
export function ariaShortcut(shortcut: string): string {
  const control = kIsMac ? 'Meta' : 'Control';
  return shortcut
    .split(/,\s*/)
    .map((keys) => keys.replaceAll('Ctrl', control))
    .join(' ');
}
