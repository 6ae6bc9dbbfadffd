// Files in and out: drop anywhere, paste, the file picker, the camera, and downloads.
import { byId, make } from './dom.ts';
import { isTextField } from './keyboard.ts';

type TakeFiles = (files: File[]) => void;

/** Shows a curtain while files hang over the page and takes them wherever they fall. */
function connectDrop(take: TakeFiles, refuse: () => void): void {
  const curtain = byId('drop-curtain');
  const hasFiles = (event: DragEvent) => event.dataTransfer?.types.includes('Files') ?? false;
  window.addEventListener('dragover', (event) => {
    event.preventDefault();
    if (event.dataTransfer) event.dataTransfer.dropEffect = hasFiles(event) ? 'copy' : 'none';
    curtain.hidden = !hasFiles(event);
  });
  window.addEventListener('dragleave', (event) => {
    if (event.relatedTarget === null) curtain.hidden = true;
  });
  window.addEventListener('drop', (event) => {
    event.preventDefault();
    curtain.hidden = true;
    const files = [...(event.dataTransfer?.files ?? [])];
    if (files.length > 0) take(files);
    else refuse();
  });
}

function connectPaste(take: TakeFiles): void {
  window.addEventListener('paste', (event) => {
    if (isTextField(event.target)) return;
    const files = [...(event.clipboardData?.files ?? [])];
    if (files.length === 0) return;
    event.preventDefault();
    take(files);
  });
}

/** The hidden inputs of the page: any picture file, model files, and the camera of a phone. */
function connectPickers(take: TakeFiles): void {
  for (const id of ['file-picker', 'model-picker', 'camera-picker']) {
    const input = byId<HTMLInputElement>(id);
    input.addEventListener('change', () => {
      const files = [...(input.files ?? [])];
      input.value = ''; // the same file can be chosen again
      if (files.length > 0) take(files);
    });
  }
}

/** All ways in; `refuse` is called when something was dropped that is no file. */
export function connectFiles(take: TakeFiles, refuse: () => void): void {
  connectDrop(take, refuse);
  connectPaste(take);
  connectPickers(take);
}

/** Opens the browser's file dialog; needs a user gesture. */
export function pickPicture(): void {
  byId<HTMLInputElement>('file-picker').click();
}

/** The same for model files. */
export function pickModel(): void {
  byId<HTMLInputElement>('model-picker').click();
}

/** Bytes of a file; fewer, where they are not there or cannot be read. */
async function bytesOf(file: Blob, from: number, count: number): Promise<DataView> {
  const bytes = await file
    .slice(from, from + count)
    .arrayBuffer()
    .catch(() => new ArrayBuffer(0));
  return new DataView(bytes);
}

const lettersOf = (bytes: DataView, from: number, count: number) =>
  String.fromCharCode(
    ...Array.from({ length: Math.min(count, bytes.byteLength - from) }, (_, i) => bytes.getUint8(from + i)),
  );

/** Whether one of the chunks of a PNG holds a model (engine/io/png_model.h). */
async function hasModelChunk(png: Blob): Promise<boolean> {
  for (let at = 8; at + 12 <= png.size;) {
    const head = await bytesOf(png, at, 8);
    const type = head.byteLength < 8 ? 'IEND' : lettersOf(head, 4, 4);
    if (type === 'spLf') return true;
    if (type === 'IEND' || type === 'IDAT') return false; // it stands in front of the pixels
    at += 12 + head.getUint32(0);
  }
  return false;
}

/** Whether a file is a GLB, a project of ours or of another program, or a PNG with a model inside. */
export async function isModelFile(file: Blob): Promise<boolean> {
  const head = await bytesOf(file, 0, 8);
  if (lettersOf(head, 0, 4) === 'glTF') return true;
  return lettersOf(head, 0, 8) === '\x89PNG\r\n\x1a\n' && hasModelChunk(file);
}

/** Offers bytes as a download. */
export function download(name: string, mediaType: string, bytes: Uint8Array): void {
  const address = URL.createObjectURL(new Blob([bytes as BlobPart], { type: mediaType }));
  const link = make('a', { href: address, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  // Some browsers read the address after the click has returned.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}
