// Photos for the store: their working copies deflated, so that a picture of 4 megapixels takes about a third
// of its 16 MB, without losing a bit.

/** Pixels of a photo's working copy, and the size of the original. */
export interface RawPhoto {
  hash: string;
  width: number;
  height: number;
  originalWidth: number;
  originalHeight: number;
  /** RGBA, rows from the top. */
  rgba: Uint8Array;
}

/** A photo as it is stored. */
export interface PackedPhoto extends Omit<RawPhoto, 'rgba'> {
  packing: 'deflate-raw' | 'none';
  bytes: Uint8Array;
}

/** A browser packs what it is given in one go, on the page's own thread: about 10 ms of this. */
const kPieceBytes = 1 << 20;

/** Piece by piece, and frames are drawn between. */
async function feed(bytes: Uint8Array, writer: WritableStreamDefaultWriter<BufferSource>): Promise<void> {
  for (let at = 0; at < bytes.length; at += kPieceBytes) {
    await writer.write(bytes.subarray(at, at + kPieceBytes) as BufferSource);
    await new Promise((resolve) => setTimeout(resolve, 0));
  }
  await writer.close();
}

async function through(
  bytes: Uint8Array,
  stream: CompressionStream | DecompressionStream,
  most: number,
): Promise<Uint8Array> {
  // What goes wrong with writing is told to the reader.
  void feed(bytes, stream.writable.getWriter()).catch(() => undefined);
  const reader = stream.readable.getReader();
  const chunks: Uint8Array[] = [];
  let length = 0;
  for (let step = await reader.read(); !step.done; step = await reader.read()) {
    length += step.value.length;
    if (length > most) {
      await reader.cancel();
      throw new Error('a packed photo is larger than it says');
    }
    chunks.push(step.value);
  }
  const all = new Uint8Array(length);
  let at = 0;
  for (const chunk of chunks) {
    all.set(chunk, at);
    at += chunk.length;
  }
  return all;
}

/** As small as this browser can make it. */
export async function packPhoto(photo: RawPhoto): Promise<PackedPhoto> {
  const { rgba, ...about } = photo;
  if (typeof CompressionStream !== 'function') return { ...about, packing: 'none', bytes: rgba };
  const bytes = await through(rgba, new CompressionStream('deflate-raw'), Infinity);
  return bytes.length < rgba.length
    ? { ...about, packing: 'deflate-raw', bytes }
    : { ...about, packing: 'none', bytes: rgba };
}

/** The pixels again; null when they are damaged. */
export async function unpackPhoto(photo: PackedPhoto): Promise<RawPhoto | null> {
  const { packing, bytes, ...about } = photo;
  const length = 4 * photo.width * photo.height;
  try {
    const rgba = packing === 'none' ? bytes : await through(bytes, new DecompressionStream('deflate-raw'), length);
    return rgba.length === length ? { ...about, rgba } : null;
  } catch {
    return null;
  }
}
