// Small helpers around the DOM. What `make` and `setAttribute` are given to show is English, or what `t` gave; it is
// shown in the visitor's language, also when that changes while it is there.
import { t } from './words/words.ts';

/** The element with this id; the page's own markup guarantees it. */
export function byId<T extends HTMLElement = HTMLElement>(id: string): T {
  const element = document.getElementById(id);
  if (!element) throw new Error(`index.html lacks #${id}`);
  return element as T;
}

type Attributes = Record<string, string | boolean | undefined>;

/** Attributes that are shown or read out. */
const kSpoken = ['aria-label', 'title', 'placeholder', 'alt', 'data-tip'];
const kLetters = /\p{L}{2}/u;

/** The English of texts and attributes that stand in the page. */
const englishTexts = new WeakMap<Text, string>();
const englishAttributes = new WeakMap<Element, Map<string, string>>();

/** Text with what surrounds it left as it is. */
function inLanguage(english: string): string {
  const words = english.trim();
  return words === '' ? english : english.replace(words, () => t(words));
}

function spokenAttribute(element: Element, name: string, english: string): string {
  const all = englishAttributes.get(element) ?? new Map<string, string>();
  englishAttributes.set(element, all.set(name, english));
  return t(english);
}

function spokenText(english: string): Text {
  const text = new Text(inLanguage(english));
  if (kLetters.test(english)) englishTexts.set(text, english);
  return text;
}

function* textsIn(root: Node): Generator<Text> {
  const walker = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) yield walker.currentNode as Text;
}

/** Takes the words that index.html came with as English. */
export function adoptWords(root: HTMLElement): void {
  for (const text of textsIn(root)) if (kLetters.test(text.data)) englishTexts.set(text, text.data);
  for (const name of kSpoken) {
    for (const element of root.querySelectorAll(`[${name}]`)) {
      spokenAttribute(element, name, element.getAttribute(name) ?? '');
    }
  }
}

/** Everything that stands in the page in the language that is spoken now. */
export function translatePage(): void {
  for (const text of textsIn(document.body)) {
    const english = englishTexts.get(text);
    if (english !== undefined) text.data = inLanguage(english);
  }
  for (const element of document.body.querySelectorAll(kSpoken.map((name) => `[${name}]`).join())) {
    for (const [name, english] of englishAttributes.get(element) ?? []) element.setAttribute(name, t(english));
  }
}

/** A text that is no word of the page, such as a name that a visitor typed. */
export function asIs(text: string): Text {
  return new Text(text);
}

/** A new element: attributes (false and undefined are left out, true is empty) and children. */
export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === false) continue;
    if (value === true) element.setAttribute(name, '');
    else element.setAttribute(name, kSpoken.includes(name) ? spokenAttribute(element, name, value) : value);
  }
  element.append(...children.map((child) => (typeof child === 'string' ? spokenText(child) : child)));
  return element;
}

/** Sets or removes an attribute, touching the DOM only when it differs. */
export function setAttribute(element: Element, name: string, english: string | null): void {
  const spoken = kSpoken.includes(name) && english !== null;
  const value = spoken ? spokenAttribute(element, name, english) : english;
  if (element.getAttribute(name) === value) return;
  if (value === null) element.removeAttribute(name);
  else element.setAttribute(name, value);
}

export const kIsMac = /Mac|iPhone|iPad/.test(navigator.platform);

/** The first of the shortcuts of a command ("Delete, Backspace"). */
export function firstShortcut(shortcuts: string): string {
  return shortcuts.split(/,\s*/)[0] ?? '';
}

/** What is printed on the keys. */
const kArrows: Record<string, string> = { ArrowLeft: '←', ArrowRight: '→', ArrowUp: '↑', ArrowDown: '↓' };

/** "Ctrl+Z" as this machine's keyboard says it. */
export function shortcutText(shortcut: string): string {
  const spoken: Record<string, string> = { Ctrl: t('Ctrl'), Shift: t('Shift'), Arrows: t('Arrows') };
  const shown = shortcut.replace(/Arrow(Left|Right|Up|Down)/g, (key) => kArrows[key] ?? key);
  if (!kIsMac) return shown.replace(/Ctrl|Shift|Arrows/g, (key) => spoken[key] ?? key);
  return shown.replaceAll('Ctrl+', '⌘').replaceAll('Shift+', '⇧').replaceAll('Alt+', '⌥');
}

/** The same in the form of aria-keyshortcuts. */
export function ariaShortcut(shortcut: string): string {
  const control = kIsMac ? 'Meta' : 'Control';
  return shortcut
    .split(/,\s*/)
    .map((keys) => keys.replaceAll('Ctrl', control))
    .join(' ');
}
