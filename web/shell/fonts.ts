// The page's fonts: the same bytes serve the DOM (FontFace) and the canvas (Dear ImGui).
import textAddress from '@expo-google-fonts/inter/400Regular/Inter_400Regular.ttf';
import boldAddress from '@expo-google-fonts/inter/600SemiBold/Inter_600SemiBold.ttf';
import iconAddress from 'lucide-static/font/lucide.ttf';

/** The bytes of the fonts that the canvas always has. */
export interface Fonts {
  text: Uint8Array;
  bold: Uint8Array;
  icons: Uint8Array;
}

async function fetchBytes(address: string): Promise<Uint8Array> {
  const response = await fetch(new URL(address, import.meta.url));
  if (!response.ok) throw new Error(`${address}: ${response.status}`);
  return new Uint8Array(await response.arrayBuffer());
}

/** Beside Inter in the style sheet, with the language behind it. */
const kScriptFamily = 'SpineLoft Script';

async function addFace(bytes: Uint8Array, weight: string, family = 'Inter'): Promise<Uint8Array> {
  document.fonts.add(await new FontFace(family, bytes as BufferSource, { weight }).load());
  return bytes;
}

const scripts = new Map<string, Promise<Script>>();

/** The letters that Inter lacks, of the language that is spoken; null where it lacks none, or they do not load. */
export interface Script {
  text: Uint8Array;
  bold: Uint8Array;
}
export async function loadScript(language: string): Promise<Script | null> {
  const files = SPINELOFT_SITE.scripts[language];
  if (!files) return null;
  try {
    if (!scripts.has(language)) scripts.set(language, fetchScript(language, files));
    return await scripts.get(language)!;
  } catch (thrown) {
    scripts.delete(language);
    console.warn(thrown);
    return null;
  }
}

async function fetchScript(language: string, files: { text: string; bold: string }): Promise<Script> {
  const face = async (path: string, weight: string) =>
    addFace(await fetchBytes(new URL(path, document.baseURI).href), weight, `${kScriptFamily} ${language}`);
  const [text, bold] = await Promise.all([face(files.text, '400'), face(files.bold, '500 700')]);
  return { text, bold };
}

/** Loads Inter for the DOM and all three fonts for the canvas. */
export async function loadFonts(): Promise<Fonts> {
  const [text, bold, icons] = await Promise.all([
    fetchBytes(textAddress).then((bytes) => addFace(bytes, '400')),
    fetchBytes(boldAddress).then((bytes) => addFace(bytes, '500 700')),
    fetchBytes(iconAddress),
  ]);
  return { text, bold, icons };
}
