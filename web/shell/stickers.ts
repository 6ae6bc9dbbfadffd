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
  url: string;
  name: string;
  /** Address of a picture; null while there is none. */
  picture: string | null;
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

function stickerOf({ url, name, picture }: Sticker): HTMLElement {
  const words = make('div', { class: 'sticker-words' });
  if (picture) words.append(make('img', { src: picture, alt: '' }));
  words.append(make('b', {}, asIs(name)), make('span', {}, 'Scan me'));
  return make('div', { class: 'sticker' }, qrCode(url).svg, words);
}

/** Opens the system's print dialog with the sheet; the page looks as before when it closes. */
export function printStickers(sticker: Sticker): void {
  document.querySelector('.stickers')?.remove();
  const { side, columns, rows } = sheetOf(qrCode(sticker.url).modules);
  const sheet = make('div', {
    class: 'stickers',
    style: `--side: ${side}mm; --columns: ${columns}`,
  });
  for (let i = 0; i < columns * rows; ++i) sheet.append(stickerOf(sticker));
  document.body.append(sheet);
  window.addEventListener('afterprint', () => sheet.remove(), { once: true });
  window.print();
}
