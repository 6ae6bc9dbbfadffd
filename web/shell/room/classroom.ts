// A class as one page takes part in it: as a pupil, as the teacher, or as a screen that shows the wall.
import { hideBanner, showBanner } from '../banner.ts';
import { askChoice } from '../dialogs.ts';
import { asIs, byId, make } from '../dom.ts';
import type { Engine } from '../engine.ts';
import { Failure, sentenceOf } from '../failure.ts';
import { download } from '../files.ts';
import { icon } from '../icons.ts';
import { animalOf } from '../keep/animals.ts';
import { toast } from '../toasts.ts';
import { t } from '../words/words.ts';
import { serverLink } from './address.ts';
import type { ServerLink } from './address.ts';
import type { Card } from './class_room.ts';
import type { Room, RoomKey, Seat, ShareServer } from './client.ts';
import { iconButton, makerOf, pupilName } from './faces.ts';
import { handInOf } from './hand_in.ts';
import type { HandIn } from './hand_in.ts';
import { hostInfo, reachableAddress, serverSide } from './host.ts';
import { LiveRoom } from './live_room.ts';
import { recallClass, rememberClass } from './membership.ts';
import type { Membership } from './membership.ts';
import type { Message } from './messages.ts';
import type { Outbox } from './outbox.ts';
import { askOpenClass, askSeat, askWords, showBack, showCard } from './room_dialogs.ts';
import { printWall } from './stickers.ts';
import { Wall } from './wall.ts';
import type { Joining, WallView } from './wall.ts';

/** What a class needs of the page. */
export interface ClassPage {
  engine(): Engine | null;
  /** Opens a model file as a new model; resolves to its id in "Your models", if it is kept. */
  openModel(bytes: Uint8Array): Promise<string | null>;
  currentModel(): string | null;
  isOnStartPage(): boolean;
  /** The canvas may be used again. */
  back(): void;
}

type Side = Awaited<ReturnType<typeof serverSide>>;

export class Classroom {
  private membership: Membership | null = null;
  private side: Side | null = null;
  private room: Room | null = null;
  private outbox: Outbox | null = null;
  private live: LiveRoom | null = null;
  private following: 'all' | 'teacher' | null = null;
  private joining: Joining | null = null;
  private isConnected = true;
  private waiting: { count: number; why: string | null } = { count: 0, why: null };
  private handingIn = false;
  private wordsTimer = 0;
  private readonly strip = byId('class-strip');
  private readonly wall = new Wall({
    open: (card) => void this.openCard(card),
    close: () => this.closeWall(),
    redraw: () => this.draw(),
    freeze: (isFrozen) => this.try(() => this.room!.freeze(isFrozen)),
    spotlight: (card) => this.try(() => this.room!.post({ type: 'spotlight', card: card?.post ?? null })),
    newWords: () => this.try(() => this.renewWords()),
    downloadAll: () => this.try(() => this.downloadAll()),
    printStickers: () => this.try(() => printWall(this.live!.room, this.visible())),
    startEverybody: () => this.try(() => this.startEverybody()),
    end: () => void this.end(),
  });

  constructor(private readonly page: ClassPage) {
    byId('class-join').prepend(icon('users'));
    byId('class-join').addEventListener('click', () => void this.join());
    byId('class-open').addEventListener('click', () => void this.open());
  }

  /** True while this page takes part in a class. */
  get isIn(): boolean {
    return this.membership !== null;
  }

  /** Offers classes where the host has a server, and comes back to the one that this browser is in. */
  async begin(): Promise<void> {
    const { server } = await hostInfo();
    byId('class-start').hidden = server === null;
    const membership = recallClass();
    if (server === null || !membership || this.membership) return;
    await this.enter(membership).catch((thrown: unknown) => toast(sentenceOf(thrown), 'error'));
  }

  /** Follows a link to a class. */
  async follow(link: ServerLink): Promise<void> {
    const room = { id: link.id, key: link.key };
    if (this.membership?.room.id === link.id) return this.openWall();
    if (link.kind === 'wall') {
      await this.enter({ room, seat: null, animal: '', number: 0, words: null, told: 0, origins: {} });
      return this.openWall();
    }
    await this.sitDown(room);
  }

  private async server(): Promise<{ side: Side; server: ShareServer }> {
    const { server } = await hostInfo();
    if (!server) throw new Failure('NoServer', 'There is no server here that keeps classes. Ask who runs this page.');
    const side = (this.side ??= await serverSide());
    return { side, server: new side.ShareServer(server) };
  }

  // ---- coming in --------------------------------------------------------------------------------

  /** As the teacher. */
  private async open(): Promise<void> {
    const days = await askOpenClass();
    if (days === null) return;
    await this.trying(async () => {
      const { server } = await this.server();
      const room = await server.openRoom(days);
      await this.enter({ room, seat: null, animal: '', number: 0, words: null, told: 0, origins: {} });
      await this.renewWords();
      this.openWall();
    });
  }

  /** As a pupil, with the words. */
  private async join(): Promise<void> {
    const found = await askWords(async (typed) => {
      const { side, server } = await this.server();
      const words = side.readWords(typed);
      if (!words)
        throw new Failure('NotWords', 'These are not the four words. Look at the wall and type them with spaces.');
      return server.findRoom(words);
    });
    if (found) await this.trying(() => this.sitDown(found));
  }

  private async sitDown(room: RoomKey): Promise<void> {
    const { side, server } = await this.server();
    const animal = await askSeat();
    if (!animal) return;
    const seat: Seat = { id: side.newId(), secret: side.newId() };
    const place = new side.Room(server, room, seat);
    const number = await place.sit();
    await place.post({ type: 'seat', animal: animal.id, number });
    await this.enter({ room, seat, animal: animal.id, number, words: null, told: 0, origins: {} });
    toast(t('You are {animal}. Make something, then press "Hand in".', { animal: pupilName(animal.id, number) }));
  }

  private async enter(membership: Membership): Promise<void> {
    const { side, server } = await this.server();
    this.leaveQuietly();
    this.membership = membership;
    if (membership.seat || membership.room.secret) rememberClass(membership);
    const room = (this.room = new side.Room(server, membership.room, membership.seat));
    this.outbox = new side.Outbox(membership.room.id, (post, body) => room.send(post, body), {
      waiting: (count, why) => {
        this.waiting = { count, why };
        this.draw();
      },
      sent: ({ name }) => toast(t('{name} is on the wall.', { name })),
      refused: ({ name }, why) => toast(t('{name} was not handed in. {why}', { name, why: t(why) }), 'error'),
    });
    void this.outbox.begin();
    window.addEventListener('online', this.again);
    document.addEventListener('visibilitychange', this.again);
    this.listen(membership.seat ? 'teacher' : 'all');
    await this.nameJoining();
    this.draw();
  }

  private readonly again = () => void this.outbox?.flush();

  /** Follows the teacher alone, or everybody while the wall is open. */
  private listen(of: 'all' | 'teacher'): void {
    if (this.following === of || !this.room) return;
    this.live?.close();
    this.following = of;
    this.live = new LiveRoom(this.room, of, {
      changed: () => this.draw(),
      told: (post, message) => this.hear(post.seq, post.post, message),
      ended: () => this.over(),
      connected: (isConnected) => {
        this.isConnected = isConnected;
        if (isConnected) this.again();
        this.draw();
      },
    });
  }

  private leaveQuietly(): void {
    clearTimeout(this.wordsTimer);
    window.removeEventListener('online', this.again);
    document.removeEventListener('visibilitychange', this.again);
    this.live?.close();
    this.live = null;
    this.following = null;
    this.room = null;
    void this.outbox?.end();
    this.outbox = null;
    this.membership = null;
    this.waiting = { count: 0, why: null };
    hideBanner('class');
  }

  /** Everything of the class is forgotten here. */
  leave(): void {
    if (!this.membership) return;
    this.leaveQuietly();
    rememberClass(null);
    if (this.wall.isOpen) this.closeWall();
    this.draw();
  }

  private over(): void {
    this.leave();
    toast('This class is over. Your models stay on this device.');
  }

  // ---- the teacher's ----------------------------------------------------------------------------

  private async renewWords(): Promise<void> {
    const { membership } = this;
    if (!membership?.room.secret) return;
    const { server } = await this.server();
    membership.words = await server.nameRoom(membership.room);
    rememberClass(membership);
    await this.nameJoining();
    this.draw();
  }

  private async nameJoining(): Promise<void> {
    const { membership } = this;
    if (!membership || membership.seat) {
      this.joining = null;
      return;
    }
    const base = await reachableAddress();
    const { words } = membership;
    const left = words ? words.expires - Date.now() : 0;
    this.joining = {
      address: base.replace(/^https?:\/\//, '').replace(/\/$/, ''),
      link: serverLink(base, { kind: 'class', ...membership.room }),
      words: words && left > 0 ? words.words : null,
    };
    clearTimeout(this.wordsTimer);
    if (left > 0)
      this.wordsTimer = window.setTimeout(() => void this.nameJoining().then(() => this.draw()), left + 500);
  }

  /** With a model of the wall, or with what is open. Pupils need not know the wall: the model is posted for them. */
  private async startEverybody(card?: Card): Promise<void> {
    const room = this.room!;
    const { name, bytes } = card ? { name: card.name, bytes: await this.glbOf(card) } : await this.openNow();
    const model = await room.post({ type: 'model' }, bytes);
    await room.post({ type: 'start', model, name });
    toast('Everybody can begin with it now.');
  }

  /** What is open here, as a model file. */
  private async openNow(): Promise<{ name: string; bytes: Uint8Array }> {
    if (this.page.isOnStartPage())
      throw new Failure('NothingToShow', 'Open a picture or a model first: everybody begins with what you have open.');
    return { bytes: await window.spineloft.exportModel('spineloft'), name: this.page.engine()!.about().name };
  }

  private visible(): Card[] {
    const { room } = this.live!;
    return room.wall().filter((card) => !room.isHidden(card));
  }

  private async downloadAll(): Promise<void> {
    const side = this.side!;
    const { room } = this.live!;
    const all: Record<string, [Uint8Array, { level: 0 }]> = {};
    for (const [i, card] of this.visible().entries()) {
      const files = await this.filesOf(card);
      const folder = `${String(i + 1).padStart(2, '0')} ${makerOf(room, card).name} - ${card.name}`;
      const clean = folder
        .replace(/[\\/:*?"<>|\p{Cc}]/gu, '_')
        .slice(0, 80)
        .trim();
      for (const [name, bytes] of Object.entries(files)) all[`${clean}/${name}`] = [bytes, { level: 0 }];
    }
    if (Object.keys(all).length === 0) throw new Failure('NothingToExport', 'There is nothing on the wall yet.');
    download('class.zip', 'application/zip', side.zipSync(all));
    toast(t('Saved {file}.', { file: 'class.zip' }));
  }

  private async end(): Promise<void> {
    const answer = await askChoice(
      'End the class',
      'The wall and everything that was handed in is deleted from the server now. Download all first if you want to keep it.',
      [
        { value: 'end', label: 'End the class' },
        { value: 'stay', label: 'Cancel' },
      ],
    );
    if (answer !== 'end') return;
    await this.trying(async () => {
      await this.room!.end();
      this.leave();
      toast('The class is over, and everything on its wall is gone.');
    });
  }

  // ---- the pupil's ------------------------------------------------------------------------------

  /** What the teacher said; each is told once. */
  private hear(seq: number, post: string, message: Message): void {
    const { membership } = this;
    if (!membership?.seat || seq <= membership.told) return;
    membership.told = seq;
    rememberClass(membership);
    if (message.type === 'back' && message.to === membership.seat.id) void this.showBack(message);
    else if (message.type === 'start') void this.offerStart(message);
    else if (message.type === 'spotlight' && message.card !== null)
      toast('Look: your teacher shows a model on the wall.', 'hint', { label: 'Our wall', run: () => this.openWall() });
    void post;
  }

  private async offerStart({ model, name }: Extract<Message, { type: 'start' }>): Promise<void> {
    const begin = () =>
      this.trying(async () => {
        const read = await this.room!.read(model, null).catch(() => null);
        if (read?.message.type !== 'model')
          throw new Failure('NotThere', 'This model could not be read. Ask for it again.');
        await this.page.openModel(read.bytes);
        this.closeWall();
      });
    if (this.page.isOnStartPage()) return begin();
    showBanner({
      id: 'class',
      text: t('Your teacher wants everybody to begin with {name}.', { name }),
      actions: [
        {
          label: 'Begin with it',
          run: () => {
            hideBanner('class');
            void begin();
          },
        },
      ],
      canDismiss: true,
    });
  }

  private async showBack(back: Extract<Message, { type: 'back' }>): Promise<void> {
    const { membership, room } = this;
    if (!membership?.seat || !room) return;
    const read = await room.read(back.card, membership.seat.id).catch(() => null);
    if (read?.message.type !== 'card') return;
    const { model } = read.message;
    const files = await this.filesOf({ model, seat: membership.seat.id }).catch(() => null);
    const picture = files?.['picture.png'] ? pictureAddress(files['picture.png']) : null;
    showBack(back, picture, () => {
      const glb = files?.['model.glb'];
      if (glb) this.try(() => this.page.openModel(glb));
    });
  }

  private async handIn(): Promise<void> {
    const { page, room, outbox, membership, side } = this;
    const engine = page.engine();
    if (!engine || !room || !outbox || !membership || !side || this.handingIn) return;
    this.handingIn = true;
    this.draw();
    try {
      const made: HandIn = await handInOf(engine);
      const [model, card] = [side.newId(), side.newId()];
      const from = membership.origins[page.currentModel() ?? ''] ?? null;
      const { name, text, frames, pictures, files } = made;
      const message: Message = { type: 'card', name: name.slice(0, 200), model, frames, text, from };
      await outbox.add({
        id: card,
        room: membership.room.id,
        name,
        posts: [
          { post: model, body: room.sealed(model, { type: 'model' }, files) },
          { post: card, body: room.sealed(card, message, pictures) },
        ],
      });
    } catch (thrown) {
      toast(sentenceOf(thrown), 'error');
    } finally {
      this.handingIn = false;
      this.draw();
    }
  }

  // ---- the wall ---------------------------------------------------------------------------------

  private openWall(): void {
    const { membership } = this;
    if (!membership) return;
    const view: WallView = membership.seat ? 'pupil' : membership.room.secret ? 'teacher' : 'screen';
    this.listen('all');
    this.wall.show(view);
    this.draw();
  }

  private closeWall(): void {
    this.wall.close();
    if (this.membership?.seat) this.listen('teacher');
    this.page.back();
  }

  /** The files of a hand-in, by name. */
  private async filesOf({ model, seat }: Pick<Card, 'model' | 'seat'>): Promise<Record<string, Uint8Array>> {
    const read = await this.room!.read(model, seat);
    if (!read) throw new Failure('NotThere', 'This model could not be read. Ask for it again.');
    return this.side!.unzipSync(read.bytes, { filter: ({ originalSize }) => originalSize < 100_000_000 });
  }

  private async glbOf(card: Card): Promise<Uint8Array> {
    const glb = (await this.filesOf(card))['model.glb'];
    if (!glb) throw new Failure('NotThere', 'This model could not be read. Ask for it again.');
    return glb;
  }

  private async openCard(card: Card): Promise<void> {
    const { membership, live } = this;
    if (!membership || !live || this.wallIsScreen()) return;
    const { room } = live;
    const maker = makerOf(room, card).name;
    const files = await this.filesOf(card).catch(() => null);
    const picture = files?.['picture.png'] ? pictureAddress(files['picture.png']) : null;
    showCard(card, maker, picture, {
      isTeacher: membership.room.secret !== undefined,
      isOwn: card.seat !== null && card.seat === membership.seat?.id,
      isHidden: room.isHidden(card),
      isShown: room.spotlight === card.post,
      spotlight: (isShown) => this.try(() => this.room!.post({ type: 'spotlight', card: isShown ? card.post : null })),
      hide: (isHidden) => this.try(() => this.room!.hide(card.post, isHidden)),
      handBack: (at, words) =>
        this.try(async () => {
          await this.room!.post({ type: 'back', card: card.post, to: card.seat!, at, words });
          toast(t('Handed back to {animal}.', { animal: maker }));
        }),
      remix: () =>
        this.try(async () => {
          const id = await this.page.openModel(await this.glbOf(card));
          if (id && card.seat !== membership.seat?.id) {
            membership.origins[id] = maker;
            rememberClass(membership);
          }
          this.closeWall();
        }),
      startEverybody: () => this.try(() => this.startEverybody(card)),
    });
  }

  private wallIsScreen(): boolean {
    return this.membership?.seat === null && this.membership.room.secret === undefined;
  }

  // ---- what is shown ----------------------------------------------------------------------------

  private try(work: () => Promise<unknown>): void {
    void this.trying(work);
  }

  private async trying(work: () => Promise<unknown>): Promise<void> {
    try {
      await work();
    } catch (thrown) {
      toast(sentenceOf(thrown), 'error');
    }
  }

  private draw(): void {
    this.drawStrip();
    if (this.live) this.wall.update(this.live.room, this.joining, this.isConnected);
  }

  private stripKey = '';

  private drawStrip(): void {
    const { membership, live, waiting } = this;
    this.strip.hidden = membership === null || this.wallIsScreen();
    const frozen = live?.room.state.frozen === true;
    const key = JSON.stringify([
      membership?.room.id,
      membership?.number,
      frozen,
      waiting,
      this.isConnected,
      this.handingIn,
    ]);
    if (key === this.stripKey) return;
    this.stripKey = key;
    if (!membership) return this.strip.replaceChildren();
    const who = membership.seat
      ? make(
          'span',
          { class: 'class-who' },
          icon(animalOf(membership.animal)?.id ?? 'circle'),
          asIs(pupilName(membership.animal, membership.number)),
        )
      : make('span', { class: 'class-who' }, icon('users'), t('Your class'));
    const says = make('span', { class: 'class-says', role: 'status' }, this.says(frozen));
    const buttons: HTMLElement[] = [iconButton('layout-grid', 'Our wall', () => this.openWall())];
    if (membership.seat) {
      const hand = iconButton('send', 'Hand in', () => void this.handIn(), 'button-primary');
      hand.disabled = this.handingIn;
      buttons.unshift(hand);
    }
    buttons.push(iconButton('x', 'Leave', () => void this.askLeave()));
    this.strip.replaceChildren(who, says, ...buttons);
  }

  private says(frozen: boolean): string {
    const { count, why } = this.waiting;
    if (this.handingIn) return t('Handing in …');
    if (frozen && this.membership?.seat) return t('Your teacher has paused the class.');
    if (count > 0) return why ? t('Waiting to be sent: it goes on by itself.') : t('Sending …');
    return this.isConnected ? '' : t('Connecting again …');
  }

  private async askLeave(): Promise<void> {
    const isTeacher = this.membership?.seat === null;
    const answer = await askChoice(
      'Leave the class',
      isTeacher
        ? 'Only this browser can lead the class. Leave it open until the lesson is over, or end the class on the wall.'
        : 'Your models stay on this device. What you handed in stays on the wall.',
      [
        { value: 'leave', label: 'Leave' },
        { value: 'stay', label: 'Cancel' },
      ],
    );
    if (answer === 'leave') this.leave();
  }
}

/** An address of a picture, for as long as a dialog is likely to be open. */
function pictureAddress(bytes: Uint8Array): string {
  const address = URL.createObjectURL(new Blob([bytes as BlobPart], { type: 'image/png' }));
  setTimeout(() => URL.revokeObjectURL(address), 300_000);
  return address;
}
