// A sheet of stickers to print and cut: each with the QR code of the model, its picture and its name.
import './styles/stickers.css';
import { asIs, make } from './dom.ts';
import { qrCode } from './qr.ts';

/** What fits on A4 and on US Letter within the margins of usual printers, millimetres. */
const kSheet = { width: 190, height: 254 };
/** A phone reads modules of this size on paper; no code is smaller than a thumb, millimetres. */
const kModule = 0.5,
  kSmallest = 32;
/** Round a code, and what stands beside it, millimetres. */
const kMargin = 4,
  kBeside = 26;

export interface Sticker {
  /** What the code leads to; null: no code. */
  url: string | null;
  name: string;
  /** Who made it; null: what to do with the code stands there. */
  maker: Node | null;
  /** A new picture of it; null while there is none. */
  picture(): Node | null;
}

/** How large a code of so many modules is printed, and how many stickers a sheet takes. */
export function sheetOf(modules: number): { side: number; columns: number; rows: number } {
  const side = Math.max(kSmallest, modules * kModule);
  return {
    side,
    columns: Math.max(1, Math.floor(kSheet.width / (side + kBeside + kMargin))),
    rows: Math.max(1, Math.floor(kSheet.height / (side + kMargin))),
  };
}

function stickerOf({ url, name, maker, picture }: Sticker): HTMLElement {
  const words = make('div', { class: 'sticker-words' });
  const shown = picture();
  if (shown) words.append(shown);
  words.append(make('b', {}, asIs(name)), maker ?? make('span', {}, 'Scan me'));
  return make('div', { class: 'sticker' }, ...(url ? [qrCode(url).svg] : []), words);
}

/** Prints these stickers through the system's dialog; `end` when it closes, and the page looks as before. */
export async function printSheet(stickers: Sticker[], end: () => void = () => undefined): Promise<void> {
  document.querySelector('.stickers')?.remove();
  const { side, columns } = sheetOf(Math.max(0, ...stickers.map(({ url }) => (url ? qrCode(url).modules : 0))));
  const sheet = make(
    'div',
    { class: 'stickers', style: `--side: ${side}mm; --columns: ${columns}` },
    ...stickers.map(stickerOf),
  );
  document.body.append(sheet);
  await Promise.all([...sheet.querySelectorAll('img')].map((image) => image.decode().catch(() => undefined)));
  const close = () => {
    sheet.remove();
    end();
  };
  window.addEventListener('afterprint', close, { once: true });
  window.print();
}

/** A whole sheet of one. */
export function printCopies(sticker: Sticker & { url: string }): Promise<void> {
  const { columns, rows } = sheetOf(qrCode(sticker.url).modules);
  return printSheet(Array.from({ length: columns * rows }, () => sticker));
}
