// The models of this device: which one is open here, bringing it back, changing to another one, and what is said
// when keeping does not work. One tab writes a model (claims.ts); every step of it is written down (journal_writer.ts).
import { hideBanner, showBanner } from '../banner.ts';
import { Failure, sentenceOf } from '../failure.ts';
import { isBlank } from '../shell_view.ts';
import type { ShellView } from '../shell_view.ts';
import { toast, toastOfModel, withdrawToasts } from '../toasts.ts';
import { animalOf } from './animals.ts';
import type { Animal } from './animals.ts';
import { makeClaims } from './claims.ts';
import type { Claims } from './claims.ts';
import { JournalWriter, kTrashMs } from './journal_writer.ts';
import type { HistorySource, JournalEvent } from './journal_writer.ts';
import { unpackPhoto } from './pack.ts';
import type { RawPhoto } from './pack.ts';
import { recall, remember, tabName } from './session.ts';
import { kOpenModel, ModelStore, newModelId } from './store.ts';
import type { KeptModel, ModelInfo } from './store.ts';
import { shrunkPicture } from './thumbnail.ts';
import { StoreFailure, storeFailureOf } from './trouble.ts';
import { nameText } from '../words/names.ts';
import { language, t } from '../words/words.ts';

/** What the keeper needs of the engine. */
export interface KeptEngine extends HistorySource {
  layPhotoBy(photo: RawPhoto): string;
  /** Replaces the model; an empty base is an empty one. How many records were damaged. Throws a Failure, and then nothing has changed. */
  restore(base: string, records: string[]): number;
  openProject(bytes: Uint8Array, photos: Record<string, RawPhoto>): void;
  run(id: string, args?: Record<string, unknown>): void;
  thumbnail(width: number, height: number): Uint8ClampedArray | null;
  isIdle(): boolean;
  readonly view: ShellView;
}

/** What the keeper needs of the page. */
export interface KeeperPage {
  /** The list of models or the state of keeping is another one. */
  changed(): void;
  /** Whether this tab may change the model. */
  setReadOnly(readOnly: boolean): void;
  /** Whether what was done last is not on the disk yet although a moment has gone by. */
  setLate(isLate: boolean): void;
  showModels(): void;
  /** Under which animal so many models are put away; null: under none. */
  askAnimal(models: number): Promise<Animal | null>;
  /** Everything is as on a first visit, but for the models that are kept. */
  beginAfresh(): void;
  pickModelFile(): void;
  showShare(): void;
  askName(title: string, text: string, value: string): Promise<string | null>;
  /** True when the model may go although it is kept nowhere. The question goes when `needless` fires. */
  mayLose(needless: AbortSignal): Promise<boolean>;
}

export type KeepEvent = { type: 'keep'; what: string; id: string };

const kThumbnail = { width: 208, height: 156 },
  kHandMs = 200, // a hand that has not moved for so long rests; until it is looked for again
  kThumbnailMs = 1200;
const kNoModel = 'none';

export class Keeper {
  private store: ModelStore | null = null;
  private trouble: StoreFailure | null = null;
  private claims: Claims | null = null;
  private writer: JournalWriter;
  private readonly token = newModelId();
  private readonly tab = tabName();
  private queue: Promise<unknown> = Promise.resolve();
  private changing = 0;
  private thumbnailTimer = 0;
  private handMovedMs = 0;
  private readOnly = false;
  private askedToPersist = false;
  private keptAgain = new AbortController();
  /** The open model, when it is to be left with nothing on it. */
  private leftBlank: string | null = null;

  constructor(
    private readonly engine: KeptEngine,
    private readonly page: KeeperPage,
  ) {
    this.writer = this.makeWriter();
    document.addEventListener('visibilitychange', () => this.seen());
    window.addEventListener('focus', () => this.writer.retry());
    document.addEventListener('pointermove', () => (this.handMovedMs = performance.now()), { passive: true });
  }

  /** Id of the open model; null while it is empty and new. */
  get current(): string | null {
    return this.writer.model;
  }

  get isBusy(): boolean {
    return this.changing > 0 || this.writer.isBusy;
  }

  /** True when closing the page loses nothing. */
  get isSafe(): boolean {
    return this.writer.isSafe && this.changing === 0;
  }

  /** Opens the store and brings back the model that was open here last. Never rejects. */
  start(): Promise<void> {
    return this.change(async () => {
      try {
        this.store = await ModelStore.open();
        this.claims = makeClaims(this.store, this.tab, {
          finish: async (id) => {
            if (id === this.current) await this.writer.settled();
          },
          lost: (id) => {
            if (id === this.current) this.lose();
          },
        });
        this.writer = this.makeWriter();
        await this.store.sweep(Date.now() - kTrashMs);
        await this.bringBack();
      } catch (thrown) {
        this.trouble = storeFailureOf(thrown);
      }
      this.page.changed();
    });
  }

  /** One step of the document. */
  take(event: JournalEvent): void {
    this.leftBlank = null;
    this.writer.take(event);
    if (event.parts > 0) this.askToPersist();
  }

  /** What a command asks for. */
  handle(event: KeepEvent): void {
    const id = event.id || null;
    switch (event.what) {
      case 'new-model':
        this.complainOf(this.newModel());
        break;
      case 'open-model':
        if (id) this.complainOf(this.openModel(id));
        else this.page.showModels();
        break;
      case 'share-model':
        this.page.showShare();
        break;
      case 'next-pupil':
        this.complainOf(this.nextPupil());
        break;
      case 'open-file':
        this.page.pickModelFile();
        break;
      case 'duplicate-model':
        this.complainOf(id ? this.duplicate(id) : this.copyHere());
        break;
      case 'delete-model':
        if (id) this.complainOf(this.remove(id));
        break;
    }
  }

  /** All models, the last changed first. */
  async list(): Promise<ModelInfo[]> {
    if (!this.store) return [];
    try {
      return await this.store.list();
    } catch {
      return [];
    }
  }

  /** Ids of models that other tabs have open. */
  async elsewhere(): Promise<Set<string>> {
    const ids = await (this.claims?.all().catch(() => []) ?? []);
    return new Set(ids.filter((id) => id !== this.current || this.readOnly));
  }

  newModel(): Promise<void> {
    return this.change(async () => {
      await this.leave();
    });
  }

  openModel(id: string): Promise<void> {
    return this.change(async () => {
      if (id === this.current && !this.readOnly) {
        const { pictures, redo } = this.engine.view;
        for (let step = 0; pictures === 0 && step < redo; ++step) this.engine.run('redo'); // all steps were taken back
        return;
      }
      if (!(await this.finishCurrent())) return;
      if (!(await this.claims?.claim(id))) {
        await this.offerHeld(id);
        return;
      }
      await this.openClaimed(id);
    });
  }

  /** Opens a project file, or a link with these photos, as a new model. Rejects with the engine's Failure, and then nothing has changed. */
  openProject(bytes: Uint8Array, photos: Record<string, RawPhoto>): Promise<void> {
    return this.change(async () => {
      if (!(await this.finishCurrent())) return;
      this.engine.openProject(bytes, photos);
      this.settleOn(null);
      this.writer.rewrite();
    });
  }

  /** Puts all models that are nobody's away under an animal, and begins afresh for whoever comes next. */
  async nextPupil(): Promise<void> {
    await this.settled();
    const blank = isBlank(this.engine.view) ? this.current : null;
    const own = (await this.list()).filter(({ id, whose }) => id !== blank && !animalOf(whose ?? null));
    const animal = own.length > 0 ? await this.page.askAnimal(own.length) : null;
    if (own.length > 0 && !animal) return;
    await this.change(async () => {
      if (!(await this.leave())) return;
      for (const { id } of own) await this.store?.setWhose(id, animal!.id);
      this.page.beginAfresh();
      if (animal)
        toast(
          t('Put away under {animal}: {models}.', {
            animal: t(animal.name),
            models: own.map(({ name }) => nameText(name)).join(', '),
          }),
        );
    });
  }

  /** A copy of a model in the list. */
  duplicate(id: string): Promise<void> {
    return this.change(async () => {
      if (id === this.current) await this.writer.settled();
      const info = await this.store?.info(id);
      if (!info) return;
      const copy = await this.store?.duplicate(id, copyName(info.name), Date.now());
      if (copy) toast(t('{name} is in your models.', { name: nameText(copy.name) }));
      this.page.changed();
    });
  }

  /** Goes on with a copy; the model as it is stays in the list. */
  copyHere(): Promise<void> {
    return this.change(async () => {
      await this.writer.settled();
      const { name } = this.engine.about();
      this.settleOn(null);
      this.writer.rewrite();
      this.engine.run('rename-model', { name: copyName(name) });
      toast(t('This is {name} now. The model as it was stays in your models.', { name: copyName(name) }));
    });
  }

  async rename(id: string): Promise<void> {
    const info = await this.store?.info(id);
    const name = info && (await this.page.askName('Rename model', 'A name for this model', info.name));
    if (!name?.trim()) return;
    await this.change(async () => {
      if (id === this.current) this.engine.run('rename-model', { name });
      else await this.store?.rename(id, name.trim().slice(0, 200));
      await this.writer.settled();
    });
  }

  /** Takes a model off the device; for a while it can be brought back. */
  remove(id: string): Promise<void> {
    return this.change(async () => {
      const info = await this.store?.info(id);
      if (!info) throw new Failure('NoSuchModel', 'There is no such model on this device.');
      if ((await this.elsewhere()).has(id))
        throw new Failure(
          'OpenElsewhere',
          t('{name} is open in another tab. Close it there first.', { name: nameText(info.name) }),
        );
      if (id === this.current && !(await this.leave())) return;
      await this.store?.delete(id, Date.now());
      if (this.writer.isInTrouble) {
        // Its room is wanted now.
        await this.store?.sweep(Date.now());
        this.writer.retry();
        return;
      }
      const bringBack = () => this.change(async () => this.store?.undelete(id));
      toast(t('{name} is deleted.', { name: nameText(info.name) }), 'info', {
        label: 'Undo',
        run: () => this.complainOf(bringBack()),
      });
    });
  }

  /** Resolves when nothing is being written or changed any more. */
  async settled(): Promise<void> {
    while (this.isBusy) {
      await this.queue.catch(() => undefined);
      await this.writer.settled();
    }
  }

  // ---- changing to another model, one after the other -------------------------------------------

  private change<T>(work: () => Promise<T>): Promise<T> {
    this.changing += 1;
    const done = this.queue.then(work, work).finally(() => {
      this.changing -= 1;
      this.page.changed();
    });
    this.queue = done.catch(() => undefined);
    return done;
  }

  private complainOf(work: Promise<unknown>): void {
    work.catch((thrown: unknown) =>
      toast(thrown instanceof StoreFailure ? thrown.message : sentenceOf(thrown), 'error'),
    );
  }

  /** An empty model in place of the open one. False when the visitor would rather stay. */
  private async leave(): Promise<boolean> {
    if (!(await this.finishCurrent())) return false;
    this.engine.restore('', []);
    this.settleOn(null);
    return true;
  }

  /** Everything of the open model is on the disk. False when the visitor would rather stay. */
  private async finishCurrent(): Promise<boolean> {
    await this.writer.settled();
    const isEmpty = this.engine.about().pictures === 0;
    if (!this.writer.isSafe && !isEmpty) {
      const { signal } = (this.keptAgain = new AbortController());
      const mayGo = await this.page.mayLose(signal);
      return signal.aborted ? this.finishCurrent() : mayGo;
    }
    if (!isEmpty) await this.keepThumbnail();
    await this.writer.settled();
    this.leftBlank = isBlank(this.engine.view) ? this.current : null;
    withdrawToasts();
    return true;
  }

  /** From now on the engine's history is this model's (null: a new one's). Nothing of the old one is pending. */
  private settleOn(info: ModelInfo | null): void {
    const old = this.current;
    if (old && old !== info?.id) this.claims?.release(old);
    // Paper that nobody has drawn on is nothing to come back to.
    if (old && old === this.leftBlank) void this.store?.delete(old, Date.now()).catch(() => undefined);
    this.leftBlank = null;
    clearTimeout(this.thumbnailTimer);
    this.setReadOnly(false);
    this.writer.attach(info);
    this.rememberOpen(info?.id ?? null);
    hideBanner('elsewhere');
  }

  private async openClaimed(id: string): Promise<void> {
    const store = this.store;
    try {
      const kept = await store?.read(id, this.token);
      if (!kept) throw new Failure('NoSuchModel', 'There is no such model on this device.');
      await this.layPhotosBy(kept);
      await this.writer.settled();
      const damaged = this.engine.restore(kept.base, kept.records) + kept.lost;
      this.settleOn(kept.info);
      if (kept.info.newName !== null) this.engine.run('rename-model', { name: kept.info.newName });
      if (damaged > 0) {
        // What comes next must not stand behind what cannot be read.
        this.writer.rewrite();
        const sentence =
          damaged === 1
            ? 'The last step of {name} could not be read and is left out.'
            : 'The last {n} steps of {name} could not be read and are left out.';
        toastOfModel(t(sentence, { n: damaged, name: nameText(kept.info.name) }), 'error');
      }
    } catch (thrown) {
      if (id !== this.current) this.claims?.release(id);
      throw thrown;
    }
  }

  private async layPhotosBy(kept: KeptModel): Promise<void> {
    for (const hash of kept.info.photos) {
      const packed = await this.store?.photo(hash);
      const photo = packed && (await unpackPhoto(packed));
      if (photo) this.engine.layPhotoBy(photo);
    }
  }

  private async bringBack(): Promise<void> {
    const id = recall('model') ?? (await this.store?.setting(kOpenModel));
    if (typeof id !== 'string' || id === kNoModel) return;
    const info = await this.store?.info(id);
    if (!info || info.deleted !== null) return;
    if (!(await this.claimPatiently(id))) {
      await this.offerHeld(id);
      return;
    }
    try {
      await this.openClaimed(id);
      const startOver = { label: 'Start a new one', run: () => this.complainOf(this.newModel()) };
      const welcome = t('Welcome back. {name} is as you left it.', { name: nameText(info.name) });
      if (info.pictures > 0) toastOfModel(welcome, 'info', startOver);
    } catch (thrown) {
      const why = t(sentenceOf(thrown));
      toast(t('{name} could not be brought back: {why}', { name: nameText(info.name), why }), 'error');
    }
  }

  /** What this tab was before may hold the model for a moment longer. */
  private async claimPatiently(id: string): Promise<boolean> {
    for (let tries = recall('model') === id ? 10 : 3; tries > 0; --tries) {
      if (await this.claims?.claim(id)) return true;
      if (tries > 1) await new Promise((resolve) => setTimeout(resolve, 100));
    }
    return false;
  }

  // ---- tabs -------------------------------------------------------------------------------------

  private async offerHeld(id: string): Promise<void> {
    const name = nameText((await this.store?.info(id))?.name ?? t('This model'));
    showBanner({
      id: 'elsewhere',
      text: t('{name} is open in another tab. To keep both from writing over each other, only one tab can change it.', {
        name,
      }),
      actions: [
        { label: 'Open a copy', command: 'duplicate-model', run: () => this.complainOf(this.openCopyOf(id)) },
        { label: 'Take over here', run: () => this.complainOf(this.takeOver(id)) },
      ],
      canDismiss: true,
    });
  }

  private openCopyOf(id: string): Promise<void> {
    return this.change(async () => {
      const info = await this.store?.info(id);
      const copy = info && (await this.store?.duplicate(id, copyName(info.name), Date.now()));
      if (!copy || !(await this.finishCurrent()) || !(await this.claims?.claim(copy.id))) return;
      await this.openClaimed(copy.id);
    });
  }

  private takeOver(id: string): Promise<void> {
    return this.change(async () => {
      if (!this.readOnly && !(await this.finishCurrent())) return;
      await this.claims?.take(id);
      await this.openClaimed(id);
    });
  }

  /** Another tab has the open model now. */
  private lose(): void {
    if (this.readOnly) return;
    const id = this.current;
    this.writer.stop();
    this.setReadOnly(true);
    showBanner({
      id: 'elsewhere',
      text: t('{name} is open in another tab now. Here it can only be looked at.', {
        name: nameText(this.engine.about().name),
      }),
      actions: [
        { label: 'Open a copy', run: () => this.complainOf(this.copyHere()) },
        {
          label: 'Take over here',
          run: () => {
            if (id) this.complainOf(this.takeOver(id));
          },
        },
      ],
      canDismiss: false,
    });
  }

  private setReadOnly(readOnly: boolean): void {
    this.readOnly = readOnly;
    this.page.setReadOnly(readOnly);
  }

  // ---- writing ----------------------------------------------------------------------------------

  private makeWriter(): JournalWriter {
    return new JournalWriter(this.engine, this.store, this.token, {
      begin: async () => {
        const id = newModelId();
        await this.claims?.claim(id);
        return id;
      },
      reopen: async () => {
        this.store?.close();
        this.store = await ModelStore.open();
        return this.store;
      },
      kept: (info) => this.onKept(info),
      trouble: (failure, since) => this.onTrouble(failure, since),
      late: (isLate) => this.page.setLate(isLate),
      taken: () => this.lose(),
    });
  }

  private onKept(info: ModelInfo): void {
    this.rememberOpen(info.id);
    this.thumbnailSoon();
    this.page.changed();
  }

  /** To read its pixels holds the page up: not while a hand moves. */
  private thumbnailSoon(wait = kThumbnailMs): void {
    clearTimeout(this.thumbnailTimer);
    const take = () => {
      const rests = performance.now() - this.handMovedMs >= kHandMs;
      return this.engine.isIdle() && rests ? void this.keepThumbnail() : this.thumbnailSoon(kHandMs);
    };
    this.thumbnailTimer = window.setTimeout(take, wait);
  }

  private onTrouble(failure: StoreFailure | null, since: number): void {
    if (!failure) {
      this.keptAgain.abort();
      hideBanner('trouble');
      toast('Your work is kept on this device again.');
      return;
    }
    const real = failure.code === 'missing' ? (this.trouble ?? failure) : failure;
    const actions = [{ label: 'Save a file', command: 'save-project', run: () => this.engine.run('save-project') }];
    if (real.code === 'full')
      actions.push({ label: 'Your models', command: 'open-model', run: () => this.page.showModels() });
    const time = new Date(since).toLocaleTimeString(language().id, { hour: '2-digit', minute: '2-digit' });
    const text = t('Not kept since {time}. {why}', { time, why: t(real.message) });
    showBanner({ id: 'trouble', text, actions, canDismiss: true });
    this.page.changed();
  }

  /** For the list; a model without one is none the worse. */
  private async keepThumbnail(): Promise<void> {
    const id = this.current;
    const pixels = id && !this.readOnly ? this.engine.thumbnail(kThumbnail.width, kThumbnail.height) : null;
    if (!id || !pixels) return;
    try {
      await this.store?.setThumbnail(id, this.token, await shrunkPicture(pixels, kThumbnail));
    } catch {
      // The next one may work.
    }
  }

  private rememberOpen(id: string | null): void {
    if (recall('model') === (id ?? kNoModel)) return;
    remember('model', id ?? kNoModel);
    void this.store?.set(kOpenModel, id ?? kNoModel).catch(() => undefined);
  }

  private seen(): void {
    if (document.visibilityState === 'hidden') void this.keepThumbnail();
    // A page that is hidden may never be seen again.
    this.writer.retry();
  }

  /** Once there is a part: browsers keep what they were asked to keep. */
  private askToPersist(): void {
    if (this.askedToPersist || !this.store) return;
    this.askedToPersist = true;
    void navigator.storage?.persist?.().catch(() => false);
  }
}

/** "Swan copy", "Swan copy 2", "Swan copy 3" … */
function copyName(name: string): string {
  const [, stem = name, , number] = /^(.*?) copy( (\d+))?$/.exec(name) ?? [];
  if (stem === name) return `${name} copy`;
  return `${stem} copy ${number ? Number(number) + 1 : 2}`;
}
