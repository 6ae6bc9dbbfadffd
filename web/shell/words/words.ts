// The visitor's language. English words stand in the code and are the keys of the catalogues (assets/words/ID.json);
// `t` gives them in the language that is spoken. Ids, keys, files and what a visitor typed are never translated.
import type { Args, Catalogue, Speaker } from './speaker.ts';

export interface Language {
  id: string;
  /** Its name in itself. */
  name: string;
  dir: 'ltr' | 'rtl';
}

export const kLanguages: readonly Language[] = [
  { id: 'en', name: 'English', dir: 'ltr' },
  { id: 'de', name: 'Deutsch', dir: 'ltr' },
  { id: 'fr', name: 'Français', dir: 'ltr' },
  { id: 'es', name: 'Español', dir: 'ltr' },
  { id: 'ja', name: '日本語', dir: 'ltr' },
  { id: 'ar', name: 'العربية', dir: 'rtl' },
];

let speaker: Speaker | null = null; // null: English
let spoken: Language = kLanguages[0]!;
const listeners = new Set<() => void>();

/** A text of the code in the visitor's language, with its arguments put in; English where there is no word for it. */
export function t(english: string, args?: Args): string {
  const text = speaker?.translated(english, args ?? {});
  if (text !== undefined && text !== null) return text;
  return args ? english.replace(/\{(\w+)\}/g, (whole, name: string) => String(args[name] ?? whole)) : english;
}

/** What the engine's canvas asks for: an empty text where there is no word. */
export const forCanvas = {
  translated: (english: string, args: string) => speaker?.translated(english, JSON.parse(args) as Args) ?? '',
  drawn: (text: string) => speaker?.drawn(text) ?? text,
};

export function language(): Language {
  return spoken;
}

/** Calls back whenever another language is spoken. */
export function onLanguage(listener: () => void): void {
  listeners.add(listener);
}

const kKey = 'spineloft.language';

function find(id: string | undefined): Language | undefined {
  return kLanguages.find((one) => one.id === id);
}

/** What the visitor chose here before, else the first language of the browser that there is. */
export function preferredLanguage(): Language {
  let chosen: string | undefined;
  try {
    chosen = localStorage.getItem(kKey) ?? undefined;
  } catch {
    // a browser that keeps nothing
  }
  const asked = [chosen, ...navigator.languages.map((tag) => tag.split('-')[0]?.toLowerCase())];
  return asked.map(find).find((one) => one !== undefined) ?? kLanguages[0]!;
}

/** Remembers the choice for the next visit. */
export function keepLanguage(id: string): void {
  try {
    localStorage.setItem(kKey, id);
  } catch {
    // It is chosen again next time.
  }
}

async function loadSpeaker(id: string): Promise<Speaker> {
  const place = (path: string | undefined) => new URL(path ?? '', document.baseURI).href;
  const [{ speakerOf }, catalogue] = await Promise.all([
    import(place(SPINELOFT_SITE.speaker)) as Promise<typeof import('./speaker.ts')>,
    fetch(place(SPINELOFT_SITE.assets[`words/${id}.json`])).then(async (response) => {
      if (!response.ok) throw new Error(`${response.url}: ${response.status}`);
      return (await response.json()) as Catalogue;
    }),
  ]);
  return speakerOf(id, catalogue);
}

/** Speaks this language from now on; rejects where its words cannot be loaded, and then nothing has changed. */
export async function speak(id: string): Promise<void> {
  const wanted = find(id);
  if (!wanted) throw new Error(`no language ${id}`);
  speaker = id === 'en' ? null : await loadSpeaker(id);
  spoken = wanted;
  document.documentElement.lang = wanted.id;
  document.documentElement.dir = wanted.dir;
  for (const listener of listeners) listener();
}
