// The wall of a class: what everybody handed in, turning. The teacher's view has what a lesson needs, the projector's
// shows the same large and without buttons; pupils see it to look and to remix.
import { asIs, byId, make } from '../dom.ts';
import { icon } from '../icons.ts';
import { qrCode } from '../qr.ts';
import { t } from '../words/words.ts';
import type { Card, ClassRoom } from './class_room.ts';
import { iconButton, makerOf, turning } from './faces.ts';

export type WallView = 'teacher' | 'projector' | 'pupil' | 'screen';

export interface WallActions {
  open(card: Card): void;
  close(): void;
  redraw(): void;
  freeze(isFrozen: boolean): void;
  spotlight(card: Card | null): void;
  newWords(): void;
  downloadAll(): void;
  printStickers(): void;
  startEverybody(): void;
  end(): void;
}

/** How the class is joined. */
export interface Joining {
  address: string;
  link: string;
  words: string[] | null;
}

export class Wall {
  private readonly element = byId('wall');
  private readonly cards = new Map<string, { element: HTMLElement; release(): void; drawn: string }>();
  private readonly grid = make('ul', { class: 'wall-cards' });
  private readonly head = make('div', { class: 'wall-head' });
  private readonly tools = make('div', { class: 'wall-tools', role: 'group', 'aria-label': 'Class' });
  private readonly stage = make('div', { class: 'wall-spot' });
  private readonly none = make('p', { class: 'wall-none' });
  private view: WallView = 'pupil';
  private drawn = '';
  private spot: { post: string; release(): void } | null = null;

  constructor(private readonly actions: WallActions) {
    this.element.replaceChildren(
      this.head,
      this.tools,
      make('div', { class: 'wall-body' }, this.stage, this.none, this.grid),
    );
    document.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || this.element.hidden || document.querySelector('dialog[open]')) return;
      if (this.view === 'projector') this.switchTo('teacher');
      else if (this.view !== 'screen') this.actions.close();
    });
  }

  get isOpen(): boolean {
    return !this.element.hidden;
  }

  show(view: WallView): void {
    this.view = view;
    this.drawn = '';
    this.element.dataset.view = view;
    this.element.hidden = false;
  }

  close(): void {
    this.element.hidden = true;
    this.spot?.release();
    this.spot = null;
    for (const { release } of this.cards.values()) release();
    this.cards.clear();
    this.grid.replaceChildren();
  }

  /** Brings the wall in step with the class. */
  update(room: ClassRoom, joining: Joining | null, isConnected: boolean): void {
    if (!this.isOpen) return;
    this.drawHead(room, joining, isConnected);
    this.drawCards(room);
    this.drawSpot(room);
  }

  private drawHead(room: ClassRoom, joining: Joining | null, isConnected: boolean): void {
    const key = JSON.stringify([this.view, joining, room.state.frozen, room.pupils.size, isConnected]);
    if (key === this.drawn) return;
    this.drawn = key;
    this.head.replaceChildren(make('h2', {}, 'Our wall'));
    const pupils = room.pupils.size === 1 ? t('1 animal is here') : t('{n} animals are here', { n: room.pupils.size });
    const facts = make('p', { class: 'wall-facts' }, pupils);
    if (room.state.frozen) facts.append(' · ', make('strong', {}, 'Paused: nothing can be handed in now'));
    if (!isConnected) facts.append(' · ', make('strong', {}, 'Connecting again …'));
    this.head.append(facts);
    if (joining) this.head.append(this.joining(joining));
    this.drawTools(room);
  }

  private joining({ address, link, words }: Joining): HTMLElement {
    const text = make('div', { class: 'wall-join-text' });
    text.append(
      make('p', {}, 'Join with the camera, or at this address:'),
      make('p', { class: 'wall-address' }, asIs(address)),
    );
    if (words) text.append(make('p', { class: 'wall-words' }, asIs(words.join(' '))));
    // A screen that takes no part does not know whether there are words.
    else if (this.view !== 'screen') text.append(make('p', {}, 'The four words have expired. The code still works.'));
    const code = qrCode(link).svg;
    code.setAttribute('aria-label', t('QR code to join the class'));
    return make('div', { class: 'wall-join' }, text, code);
  }

  private drawTools(room: ClassRoom): void {
    const { actions } = this;
    const { frozen } = room.state;
    const back = iconButton('chevron-left', 'Back to the model', () => actions.close());
    if (this.view === 'screen') this.tools.replaceChildren();
    else if (this.view === 'pupil') this.tools.replaceChildren(back);
    else if (this.view === 'projector')
      this.tools.replaceChildren(iconButton('x', "Teacher's view", () => this.switchTo('teacher')));
    else
      this.tools.replaceChildren(
        back,
        iconButton('maximize', 'Projector view', () => this.switchTo('projector'), 'button-primary'),
        iconButton(frozen ? 'circle-check' : 'hand', frozen ? 'Go on' : 'Pause', () => actions.freeze(!frozen)),
        iconButton('send', 'Start everybody', () => actions.startEverybody()),
        iconButton('refresh-cw', 'New words', () => actions.newWords()),
        iconButton('download', 'Download all', () => actions.downloadAll()),
        iconButton('image-down', 'Print stickers', () => actions.printStickers()),
        iconButton('trash-2', 'End the class', () => actions.end()),
      );
  }

  private switchTo(view: WallView): void {
    this.show(view);
    this.actions.redraw();
  }

  private drawCards(room: ClassRoom): void {
    const isTeacher = this.view === 'teacher';
    const shown = room.wall().filter((card) => isTeacher || !room.isHidden(card));
    const wanted = new Set(shown.map(({ post }) => post));
    for (const [post, { element, release }] of this.cards) {
      if (wanted.has(post)) continue;
      element.remove();
      release();
      this.cards.delete(post);
    }
    let before: Element | null = null;
    for (const card of shown) {
      const element = this.cardOf(room, card);
      const place: ChildNode | null = before ? before.nextSibling : this.grid.firstChild;
      if (place !== element) this.grid.insertBefore(element, place);
      before = element;
    }
    this.none.hidden = shown.length > 0;
    this.element.dataset.empty = String(shown.length === 0);
    if (shown.length === 0) this.none.replaceChildren(t('Nothing is handed in yet. What comes turns here at once.'));
  }

  private cardOf(room: ClassRoom, card: Card): HTMLElement {
    const maker = makerOf(room, card);
    const drawn = JSON.stringify([maker.name, room.isHidden(card), card.version, this.view]);
    const known = this.cards.get(card.post);
    if (known?.drawn === drawn) return known.element;
    known?.release();
    const { element: picture, release } = turning(card);
    const who = make('span', { class: 'wall-who' }, icon(maker.icon), asIs(maker.name));
    const name = make('span', { class: 'wall-name' }, asIs(card.name));
    const button = make('button', { type: 'button', class: 'wall-open' }, picture, who, name);
    button.setAttribute('aria-label', `${maker.name}: ${card.name}`);
    if (card.from)
      button.append(make('span', { class: 'wall-from' }, t('made from the model of {animal}', { animal: card.from })));
    if (room.isHidden(card)) button.append(make('span', { class: 'wall-hidden' }, 'Hidden'));
    button.addEventListener('click', () => this.actions.open(card));
    const element = make('li', { class: 'wall-card', 'data-post': card.post }, button);
    if (known) known.element.replaceWith(element);
    this.cards.set(card.post, { element, release, drawn });
    return element;
  }

  private drawSpot(room: ClassRoom): void {
    const card = room.shown();
    this.element.dataset.spot = String(card !== null);
    if ((card?.post ?? '') === (this.spot?.post ?? '') && this.stage.dataset.view === this.view) return;
    this.spot?.release();
    this.spot = null;
    this.stage.dataset.view = this.view;
    this.stage.replaceChildren();
    if (!card) return;
    const { element, release } = turning(card);
    const maker = makerOf(room, card);
    this.spot = { post: card.post, release };
    this.stage.append(
      element,
      make('p', { class: 'wall-spot-name' }, icon(maker.icon), asIs(` ${maker.name} · ${card.name}`)),
    );
    if (this.view === 'teacher')
      this.stage.append(iconButton('x', 'Show the whole wall', () => this.actions.spotlight(null)));
  }
}
