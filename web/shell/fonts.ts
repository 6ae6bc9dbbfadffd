// The page's fonts: the same bytes serve the DOM (FontFace) and the canvas (Dear ImGui).
import textAddress from '@expo-google-fonts/inter/400Regular/Inter_400Regular.ttf';
import boldAddress from '@expo-google-fonts/inter/600SemiBold/Inter_600SemiBold.ttf';
import iconAddress from 'lucide-static/font/lucide.ttf';
import type { Fonts } from './engine.ts';

async function fetchBytes(address: string): Promise<Uint8Array> {
  const response = await fetch(new URL(address, import.meta.url));
  if (!response.ok) throw new Error(`${address}: ${response.status}`);
  return new Uint8Array(await response.arrayBuffer());
}

async function addFace(bytes: Uint8Array, weight: string): Promise<Uint8Array> {
  document.fonts.add(await new FontFace('Inter', bytes as BufferSource, { weight }).load());
  return bytes;
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
