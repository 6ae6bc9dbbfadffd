// The models of a wall on stickers: each with its animal, and a QR code where the model fits into a link.
import { asIs, make } from '../dom.ts';
import { icon } from '../icons.ts';
import { kLinkMark } from '../links.ts';
import { printSheet } from '../stickers.ts';
import type { Card, ClassRoom } from './class_room.ts';
import { makerOf, turning } from './faces.ts';
import { reachableAddress } from './host.ts';

export async function printWall(room: ClassRoom, cards: Card[]): Promise<void> {
  const base = await reachableAddress();
  const faces = cards.map(turning);
  const stickers = cards.map((card, i) => {
    const maker = makerOf(room, card);
    return {
      url: card.text ? base + kLinkMark + card.text : null,
      name: card.name,
      maker: make('span', {}, icon(maker.icon), asIs(` ${maker.name}`)),
      picture: () => faces[i]!.element,
    };
  });
  await printSheet(stickers, () => faces.forEach(({ release }) => release()));
}
