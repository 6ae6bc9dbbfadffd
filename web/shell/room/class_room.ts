// What a class is, from the messages that were posted in its room, one after the other: who is here, what was handed in,
// what the teacher shows. A pure value; who cannot have said something is not heard.
import type { ListedPost, RoomState } from './client.ts';
import type { Message } from './messages.ts';

export interface Pupil {
  seat: string;
  animal: string;
  number: number;
}

export interface Card {
  post: string;
  /** Null: the teacher's. */
  seat: string | null;
  name: string;
  model: string;
  frames: number;
  /** The link's text of the model; empty where it is too long. */
  text: string;
  /** Whose model it was made from, as a name. */
  from: string | null;
  pictures: Uint8Array;
  /** How many this pupil has handed in, this one being the last. */
  version: number;
}

export class ClassRoom {
  readonly pupils = new Map<string, Pupil>();
  readonly cards = new Map<string, Card>();
  spotlight: string | null = null;
  start: { post: string; model: string; name: string } | null = null;
  state: RoomState = { frozen: false, hidden: [] };

  /** Takes the next post; a hand-back is returned, since it is for one pupil and for once. */
  take({ post, seat }: ListedPost, message: Message, bytes: Uint8Array): Extract<Message, { type: 'back' }> | null {
    switch (message.type) {
      case 'seat':
        if (seat !== null) this.pupils.set(seat, { seat, animal: message.animal, number: message.number });
        break;
      case 'card': {
        const { name, model, frames, text, from } = message;
        const version = [...this.cards.values()].filter((card) => card.seat === seat).length + 1;
        this.cards.set(post, { post, seat, name, model, frames, text, from, pictures: bytes, version });
        break;
      }
      case 'spotlight':
        if (seat === null) this.spotlight = message.card;
        break;
      case 'start':
        if (seat === null) this.start = { post, model: message.model, name: message.name };
        break;
      case 'back':
        return seat === null ? message : null;
      case 'model':
        break;
    }
    return null;
  }

  /** The last card of everybody, in the order in which they first handed in. */
  wall(): Card[] {
    const last = new Map<string | null, Card>();
    for (const card of this.cards.values()) last.set(card.seat, card);
    return [...last.values()];
  }

  isHidden(card: Card): boolean {
    return this.state.hidden.includes(card.post);
  }

  /** The card that the teacher shows to all; null when it is hidden. */
  shown(): Card | null {
    const card = this.spotlight === null ? undefined : this.cards.get(this.spotlight);
    return card && !this.isHidden(card) ? card : null;
  }
}
