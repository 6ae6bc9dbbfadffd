// A sheet of stickers to print: each model of the wall with its animal, and a QR code where the model fits into a link.
import { asIs, make } from '../dom.ts';
import { icon } from '../icons.ts';
import { qrCode } from '../qr.ts';
import type { Card, ClassRoom } from './class_room.ts';
import { makerOf, turning } from './faces.ts';
import { reachableAddress } from './host.ts';

export async function printStickers(room: ClassRoom, cards: Card[]): Promise<void> {
  const base = await reachableAddress();
  const pictures: { release(): void }[] = [];
  const stickers = cards.map((card) => {
    const { element, release } = turning(card);
    pictures.push({ release });
    const maker = makerOf(room, card);
    const sticker = make(
      'li',
      { class: 'sticker' },
      element,
      make('p', {}, icon(maker.icon), asIs(` ${maker.name}`)),
      make('p', {}, asIs(card.name)),
    );
    if (card.text) sticker.append(qrCode(`${base}#m=${card.text}`).svg);
    return sticker;
  });
  const sheet = make('ul', { class: 'sticker-sheet' }, ...stickers);
  document.body.append(sheet);
  await Promise.all([...sheet.querySelectorAll('img')].map((image) => image.decode().catch(() => undefined)));
  const end = () => {
    sheet.remove();
    for (const { release } of pictures) release();
  };
  window.addEventListener('afterprint', end, { once: true });
  window.print();
}
