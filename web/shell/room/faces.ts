// How pupils and their models look: an animal with a number, and a picture that turns.
import { make } from '../dom.ts';
import { icon } from '../icons.ts';
import { animalOf } from '../keep/animals.ts';
import { t } from '../words/words.ts';
import type { Card, ClassRoom } from './class_room.ts';
import { kFrameSide } from './hand_in.ts';

export const pupilName = (animal: string, number: number): string =>
  `${t(animalOf(animal)?.name ?? 'Animal')} ${number}`;

/** The maker of a card by name; the teacher's own cards say so. */
export function makerOf(room: ClassRoom, card: Card): { name: string; icon: string } {
  if (card.seat === null) return { name: t('Teacher'), icon: 'users' };
  const pupil = room.pupils.get(card.seat);
  return pupil
    ? { name: pupilName(pupil.animal, pupil.number), icon: animalOf(pupil.animal)?.id ?? 'circle' }
    : { name: t('Animal'), icon: 'circle' };
}

/** The model turning round, a frame after the other; at rest for who wants no motion (class.css). */
export function turning(card: Card): { element: HTMLElement; release(): void } {
  const address = URL.createObjectURL(new Blob([card.pictures as BlobPart]));
  const picture = make('img', {
    src: address,
    alt: '',
    width: String(card.frames * kFrameSide),
    height: String(kFrameSide),
    decoding: 'async',
  });
  const element = make('span', { class: 'turning' }, picture);
  picture.addEventListener('error', () => picture.remove()); // not a picture, whoever sent it
  element.style.setProperty('--frames', String(card.frames));
  return { element, release: () => URL.revokeObjectURL(address) };
}

export function iconButton(name: string, text: string, act: () => void, look = ''): HTMLButtonElement {
  const button = make('button', { type: 'button', class: `button ${look}` });
  button.append(icon(name), ' ', make('span', {}, text));
  button.addEventListener('click', act);
  return button;
}
