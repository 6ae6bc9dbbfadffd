// Reading a picture file's header without decoding it: its format, the size it declares, and
// whether its data reach the end. A bomb is refused here, before any decoder sees it.

export type PictureFormat = 'png' | 'jpeg' | 'gif' | 'webp' | 'bmp' | 'avif' | 'heic';

export interface Probe {
  format: PictureFormat;
  /** Declared size before any EXIF turn; null when the header does not tell. */
  width: number | null;
  height: number | null;
  /** False when the data end before the format says they do. */
  complete: boolean;
}

/** The probe of a file, or null when it begins like no picture format we know. */
export function probePicture(bytes: Uint8Array): Probe | null {
  for (const probe of [probePng, probeJpeg, probeGif, probeWebp, probeBmp, probeIsoMedia]) {
    const found = probe(bytes, new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength));
    if (found) return found;
  }
  return null;
}

function ascii(bytes: Uint8Array, at: number, length: number): string {
  return String.fromCharCode(...bytes.subarray(at, at + length));
}

function damaged(format: PictureFormat): Probe {
  return { format, width: null, height: null, complete: false };
}

function probePng(bytes: Uint8Array, view: DataView): Probe | null {
  if (ascii(bytes, 0, 8) !== '\x89PNG\r\n\x1a\n') return null;
  if (bytes.length < 24 || ascii(bytes, 12, 4) !== 'IHDR') return damaged('png');
  const size = { width: view.getUint32(16), height: view.getUint32(20) };
  for (let at = 8; at + 12 <= bytes.length;) {
    const length = view.getUint32(at);
    const end = at + 12 + length;
    if (ascii(bytes, at + 4, 4) === 'IEND') return { format: 'png', ...size, complete: end <= bytes.length };
    at = end;
  }
  return { format: 'png', ...size, complete: false };
}

/** Start-of-frame markers carry the size: C0…CF without DHT, JPG and DAC. */
function isStartOfFrame(marker: number): boolean {
  return marker >= 0xc0 && marker <= 0xcf && ![0xc4, 0xc8, 0xcc].includes(marker);
}

function hasEndOfImage(bytes: Uint8Array, from: number): boolean {
  for (let at = bytes.length - 2; at >= from; --at) {
    if (bytes[at] === 0xff && bytes[at + 1] === 0xd9) return true;
  }
  return false;
}

function probeJpeg(bytes: Uint8Array, view: DataView): Probe | null {
  if (bytes.length < 3 || bytes[0] !== 0xff || bytes[1] !== 0xd8 || bytes[2] !== 0xff) return null;
  let size: { width: number; height: number } | null = null;
  for (let at = 2; at + 4 <= bytes.length;) {
    if (bytes[at] !== 0xff) return damaged('jpeg');
    const marker = bytes[at + 1] ?? 0;
    if (marker === 0xff) {
      at += 1; // padding before a marker
      continue;
    }
    const end = at + 2 + view.getUint16(at + 2);
    if (isStartOfFrame(marker) && at + 9 <= bytes.length) {
      size = { height: view.getUint16(at + 5), width: view.getUint16(at + 7) };
    }
    if (marker === 0xda && size) {
      return { format: 'jpeg', ...size, complete: hasEndOfImage(bytes, end) };
    }
    at = end;
  }
  return size ? { format: 'jpeg', ...size, complete: false } : damaged('jpeg');
}

function probeGif(bytes: Uint8Array, view: DataView): Probe | null {
  if (!/^GIF8[79]a/.test(ascii(bytes, 0, 6))) return null;
  if (bytes.length < 14) return damaged('gif');
  const complete = bytes.lastIndexOf(0x3b) > 13;
  return { format: 'gif', width: view.getUint16(6, true), height: view.getUint16(8, true), complete };
}

function probeWebp(bytes: Uint8Array, view: DataView): Probe | null {
  if (ascii(bytes, 0, 4) !== 'RIFF' || ascii(bytes, 8, 4) !== 'WEBP') return null;
  if (bytes.length < 30) return damaged('webp');
  const complete = view.getUint32(4, true) + 8 <= bytes.length;
  const kind = ascii(bytes, 12, 4);
  if (kind === 'VP8X') {
    const three = (at: number) => view.getUint16(at, true) + 65536 * view.getUint8(at + 2);
    return { format: 'webp', width: three(24) + 1, height: three(27) + 1, complete };
  }
  if (kind === 'VP8L') {
    const packed = view.getUint32(21, true);
    return { format: 'webp', width: (packed & 0x3fff) + 1, height: ((packed >>> 14) & 0x3fff) + 1, complete };
  }
  if (kind !== 'VP8 ') return damaged('webp');
  const side = (at: number) => view.getUint16(at, true) & 0x3fff;
  return { format: 'webp', width: side(26), height: side(28), complete };
}

function probeBmp(bytes: Uint8Array, view: DataView): Probe | null {
  if (ascii(bytes, 0, 2) !== 'BM') return null;
  if (bytes.length < 26) return damaged('bmp');
  const headerSize = view.getUint32(14, true);
  if (headerSize < 12 || headerSize > 256) return null;
  const core = headerSize === 12;
  const width = core ? view.getUint16(18, true) : Math.abs(view.getInt32(18, true));
  const height = core ? view.getUint16(20, true) : Math.abs(view.getInt32(22, true));
  return { format: 'bmp', width, height, complete: view.getUint32(2, true) <= bytes.length };
}

/** AVIF and HEIC: the largest size among the `ispe` boxes near the start. */
function probeIsoMedia(bytes: Uint8Array, view: DataView): Probe | null {
  if (ascii(bytes, 4, 4) !== 'ftyp') return null;
  const brands = ascii(bytes, 8, Math.min(64, bytes.length - 8));
  const avif = /avi[fs]/.test(brands);
  if (!avif && !/hei[cxms]|hev[cxms]|mif1/.test(brands)) return null;
  let width = 0,
    height = 0;
  const last = Math.min(bytes.length - 16, 65536);
  for (let at = 8; at <= last; ++at) {
    if (bytes[at] !== 0x69 || ascii(bytes, at, 4) !== 'ispe') continue;
    width = Math.max(width, view.getUint32(at + 8));
    height = Math.max(height, view.getUint32(at + 12));
  }
  const size = width && height ? { width, height } : { width: null, height: null };
  return { format: avif ? 'avif' : 'heic', ...size, complete: true };
}
