// The page around the running engine: keeps the DOM in step with the document.
import type { Command, SharedLink } from './api.ts';
import { CommandBar } from './command_bar.ts';
import { openCommandSearch } from './command_search.ts';
import { askChoice, askText } from './dialogs.ts';
import { byId, setAttribute } from './dom.ts';
import { type Engine, type EngineEvent, type Offer, wantsThreads } from './engine.ts';
import { Failure, sentenceOf } from './failure.ts';
import { download, isModelFile, pickModel, pickPicture } from './files.ts';
import { Coach, kNewMs } from './coach.ts';
import { loadScript } from './fonts.ts';
import { Guide } from './guide.ts';
import { showHelp } from './help.ts';
import { icon } from './icons.ts';
import { askInPlace } from './in_place.ts';
import { askAnimal } from './keep/animals.ts';
import { Keeper } from './keep/keeper.ts';
import type { ModelInfo } from './keep/store.ts';
import { ModelsView } from './keep/models_view.ts';
import { Mirror } from './mirror.ts';
import { photoCopies, photosIn } from './link_photos.ts';
import { decodePicture } from './picture.ts';
import { ProgressBar } from './progress.ts';
import { commandsNow } from './shell_view.ts';
import type { ShellView } from './shell_view.ts';
import { sharedLink, showShare } from './share.ts';
import { serverLinkIn } from './room/address.ts';
import { asSharedLink, readStored, storedSection, storeModel, takeBack } from './room/stored.ts';
import { keepShelf, readShelf, watchShelf } from './shelf.ts';
import { ToolChoice, wantsAllTools } from './tool_choice.ts';
import { kSamples, sampleAddress } from './start_page.ts';
import type { Sample } from './start_page.ts';
import type { Task } from './tasks.ts';
import { toast, toastOfModel } from './toasts.ts';
import type { ToastAction } from './toasts.ts';
import { gifOf, pngOf, stillOf } from './turntable.ts';
import type { TurntableEvent } from './turntable.ts';
import { isCutOutLikely, isSolidLikely, startCutter, startSolver } from './warm_up.ts';
import { inLanguage, nameText } from './words/names.ts';
import { keepLanguage, language, onLanguage, speak, t } from './words/words.ts';

export class Page {
  private engine: Engine | null = null;
  private view: ShellView | null = null;
  private table: readonly Command[] = [];
  private keeper: Keeper | null = null;
  /** The status line was set in this turn: nobody has heard it yet. */
  private saysStep = false;
  private readOnly = false;
  private newUntil = 0;
  /** Where what the status line says is over as soon as the visitor is elsewhere; null: it stays. */
  private passing: string | null = null;
  private turning = false;
  /** Called when the device is handed on. */
  onNextPupil: () => void = () => undefined;
  private readonly opening = new Set<AbortController>();
  private readonly canvas = byId<HTMLCanvasElement>('canvas');
  private readonly home = byId<HTMLButtonElement>('home');
  private readonly bar: CommandBar;
  private readonly progress = new ProgressBar();
  private readonly guide = new Guide();
  private readonly coach = new Coach();
  private readonly tools = new ToolChoice();
  private readonly mirror = new Mirror({
    press: ({ kind, id }) => {
      if (kind === 'rib') this.run('choose-rib', { rib: id >> 1, side: id % 2 === 0 ? 'left' : 'right' });
      else this.work((engine) => engine.workControl(id));
    },
    set: (id, value) => this.work((engine) => engine.workControl(id, value)),
    show: (id) => this.engine?.showControl(id),
    nameText,
  });
  private readonly models = new ModelsView({
    list: () => this.listModels(),
    elsewhere: () => this.keeper?.elsewhere() ?? Promise.resolve(new Set()),
    current: () => this.keeper?.current ?? null,
    open: (id) => this.keep('open-model', id),
    duplicate: (id) => this.keep('duplicate-model', id),
    rename: (id) => void this.keeper?.rename(id).catch((thrown: unknown) => this.complain(thrown)),
    remove: (id) => this.keep('delete-model', id),
    nextPupil: () => this.keep('next-pupil', ''),
  });

  constructor() {
    this.bar = new CommandBar(
      (id, args) => this.run(id, args),
      () => this.engine?.commands() ?? [],
    );
    this.home.prepend(icon('house'));
    this.home.addEventListener('click', () => this.run('new-model'));
  }

  /** The engine runs: from now on the DOM follows it. */
  async attach(engine: Engine): Promise<void> {
    this.engine = engine;
    this.table = engine.commands();
    onLanguage(() => void this.follow());
    if (language().id !== 'en') await this.follow();
    engine.run('load-shelf', { slices: readShelf() });
    engine.run('more-tools', { on: wantsAllTools() });
    watchShelf((slices) => this.run('load-shelf', { slices }));
    this.keeper = new Keeper(engine, {
      changed: () => this.refresh(),
      setReadOnly: (readOnly) => this.setReadOnly(readOnly),
      setLate: (isLate) => {
        byId('keeping').hidden = !isLate;
      },
      showModels: () => this.models.showAll(),
      askAnimal,
      beginAfresh: () => this.beginAfresh(),
      pickModelFile: () => pickModel(),
      showShare: () => void this.showShare(engine).catch((thrown: unknown) => this.complain(thrown)),
      askName: (title, text, value) => askText(title, text, value),
      mayLose: (needless) => this.mayLose(needless),
    });
    await this.keeper.start();
    this.refresh();
  }

  /** The visitor has chosen something while the engine still loads; null: it will never run. */
  showLoading(cancel: (() => void) | null): void {
    const stop = () => {
      cancel?.();
      this.progress.set(null);
    };
    this.progress.set(cancel ? { label: 'Getting ready', done: null, cancel: stop } : null);
  }

  get isBusy(): boolean {
    return this.opening.size > 0 || this.turning || this.keeper?.isBusy === true;
  }

  /** True while the model can only be looked at: another tab has it. */
  get isReadOnly(): boolean {
    return this.readOnly;
  }

  /** All models that this device keeps, the last changed first. */
  async listModels(): Promise<ModelInfo[]> {
    return this.keeper?.list() ?? [];
  }

  get isOnStartPage(): boolean {
    return this.view?.picture == null;
  }

  handle(event: EngineEvent): void {
    switch (event.type) {
      case 'changed':
        this.refresh(event.view);
        break;
      case 'toast':
        // What a command says of its step takes the place of what is said of every step.
        if (event.level === 'info' && this.saysStep) this.say('');
        toastOfModel(event.text, event.level, event.offer && this.actionOf(event.offer));
        break;
      case 'file':
        download(event.name, event.mediaType, event.bytes);
        toast(t('Saved {file}.', { file: event.name }));
        break;
      case 'pickPicture':
        pickPicture();
        break;
      case 'ask':
        void this.ask(event);
        break;
      case 'cursor':
        this.canvas.style.cursor = event.css;
        break;
      case 'controls':
        this.mirror.update(event.controls);
        break;
      case 'shelf':
        keepShelf(event.slices);
        break;
      case 'status':
        this.say(event.text);
        this.saysStep = true;
        queueMicrotask(() => {
          this.saysStep = false;
        });
        break;
      case 'show':
        this.show(event.dialog);
        break;
      case 'language':
        void this.speak(event.id);
        break;
      case 'turntable':
        void this.turntable(event);
        break;
      case 'journal':
        this.keeper?.take(event);
        break;
      case 'keep':
        this.keeper?.handle(event);
        break;
    }
  }

  private actionOf({ label, command, args }: Offer): ToastAction {
    return { label, command, run: () => this.run(command, args ?? undefined) };
  }

  /** Saves a picture of the model, or the model turning round. */
  private async turntable({ what, name }: TurntableEvent): Promise<void> {
    const engine = this.engine;
    if (!engine || this.turning) return;
    this.turning = true;
    let wanted = true;
    const shown = (done: number) => {
      this.progress.set({
        label: 'Turning the model round',
        done,
        cancel: () => {
          wanted = false;
        },
      });
      return wanted;
    };
    try {
      const bytes = what === 'png' ? await pngOf(engine) : await gifOf(engine, shown);
      if (bytes) {
        download(`${name}.${what}`, `image/${what}`, bytes);
        toast(t('Saved {file}.', { file: `${name}.${what}` }));
      } else if (wanted) {
        toast('There is nothing to show yet. Draw a line through something first.', 'error');
      }
    } catch (thrown) {
      toast(sentenceOf(thrown), 'error');
    } finally {
      this.turning = false;
      this.progress.set(null);
    }
  }

  /** Runs a command for the visitor; a refusal becomes a toast. */
  run(id: string, args?: Record<string, unknown>): void {
    try {
      this.mustBeChangeable();
      this.engine?.run(id, args);
    } catch (thrown) {
      toast(sentenceOf(thrown), 'error');
    }
  }

  /** Works a control of the panels, unless nothing can be changed here. */
  private work(control: (engine: Engine) => void): void {
    try {
      this.mustBeChangeable();
      if (this.engine) control(this.engine);
    } catch (thrown) {
      toast(sentenceOf(thrown), 'error');
    }
  }

  /** Throws while another tab has the model. */
  mustBeChangeable(): void {
    if (this.readOnly)
      throw new Failure(
        'OpenElsewhere',
        'This model is open in another tab now. Open a copy or take it over to go on here.',
      );
  }

  /** Opens a dialog that is about no model: also where nothing can be changed. */
  show(dialog: 'help' | 'find-command'): void {
    const commands = this.engine?.commands();
    if (!commands) return;
    const begin = (task: Task | null) => void this.begin(task);
    const choose = (id: string) => void this.speak(id);
    if (dialog === 'help') showHelp({ commands, facts: this.facts(), begin, choose });
    else openCommandSearch(commands.map(inLanguage), (id, args) => this.run(id, args));
  }

  /** What is of use to few: the numbers behind the model. */
  private facts(): string[] {
    const { view } = this;
    if (!view?.picture) return [];
    const { selected } = view;
    const ribs =
      selected?.kind === 'loft' ? [t('{name} has {n} ribs.', { name: nameText(selected.name), n: selected.ribs })] : [];
    return [...ribs, t('Steps that can be taken back: {n}.', { n: view.undo })];
  }

  /** Begins a task on a model of its own, or leads once more through the first steps of the one that is open. */
  private async begin(task: Task | null): Promise<void> {
    if (task) {
      if (!this.isOnStartPage) await this.keeper?.newModel();
      if (!this.isOnStartPage) return; // the visitor would rather stay
    }
    // Its steps are about the model that comes: what is open before would count as done.
    this.coach.begin(task);
    if (task) {
      const sample = kSamples.find(({ id }) => id === task.on);
      if (sample) await this.openSample(sample, sampleAddress(sample), true);
      else await this.drawOnPaper();
      if (task.tool) this.run(task.tool);
    }
    this.refresh();
  }

  /** Speaks another language, and remembers it. */
  async speak(id: string): Promise<void> {
    try {
      await speak(id);
      keepLanguage(id);
    } catch (thrown) {
      console.warn(thrown);
      toast('This language could not be loaded. Check the connection and try again.', 'error');
    }
  }

  /** The language is another one: the canvas follows, and what is said about the model. */
  private async follow(): Promise<void> {
    const { engine } = this;
    if (!engine) return;
    const spoken = language();
    const script = await loadScript(spoken.id);
    if (spoken !== language()) return; // another one since
    engine.speak(spoken, script);
    this.table = engine.commands();
    document.body.dataset.language = spoken.id;
    this.refresh();
  }

  /** For the next pupil on this device: few tools, and the first steps. */
  private beginAfresh(): void {
    this.onNextPupil();
    this.run('more-tools', { on: false });
    this.coach.begin(null);
    this.refresh();
  }

  say(text: string): void {
    const status = byId('status');
    status.textContent = t(text);
    status.toggleAttribute('data-new', !this.coach.isNew);
    clearTimeout(this.newUntil);
    this.newUntil = window.setTimeout(() => status.removeAttribute('data-new'), kNewMs);
    this.passing = null;
  }

  /** Something that is said until the next thing is done. */
  private sayUntilNext(text: string): void {
    this.say(text);
    if (this.engine) this.passing = placeOf(this.engine.view);
  }

  /** Decodes and opens one picture, `begins`: as leaveUndone says; rejects when it cannot be opened, and then nothing has changed. */
  async openImage(blob: Blob, name: string, begins = false): Promise<void> {
    const engine = this.engine;
    if (!engine) throw new Failure('NotReady', 'The page is not ready yet. Wait for spineloft.ready.');
    this.mustBeChangeable();
    const aborter = new AbortController();
    this.opening.add(aborter);
    this.showProgress();
    try {
      const picture = await decodePicture(blob, engine);
      if (aborter.signal.aborted) throw new Failure('Cancelled', engine.sentence('Cancelled'));
      if (begins) await this.leaveUndone();
      engine.addPicture(picture, name);
      await Promise.resolve(); // what the engine says of the step comes first
      this.sayUntilNext(t('{name} is open.', { name }));
    } finally {
      this.opening.delete(aborter);
      this.refresh();
    }
  }

  /** Opens a model file (.spineloft, or a GLB of ours) as a new model; rejects when it is none, and then nothing has changed. */
  async openProject(blob: Blob): Promise<void> {
    const engine = this.engine,
      keeper = this.keeper;
    if (!engine || !keeper) throw new Failure('NotReady', 'The page is not ready yet. Wait for spineloft.ready.');
    const buffer = await blob.arrayBuffer().catch(() => {
      throw new Failure('FileUnreadable', engine.sentence('FileUnreadable'));
    });
    const bytes = new Uint8Array(buffer);
    await engine.whole().catch(() => undefined); // then what needs it says so
    await keeper.openProject(bytes, await photosIn(engine, bytes));
    this.guide.offer(null);
    this.sayUntilNext(t('{name} is open.', { name: nameText(engine.about().name) }));
    this.refresh();
  }

  private async showShare(engine: Engine): Promise<void> {
    const host = {
      name: engine.about().name,
      still: (side: number) => stillOf(engine, side),
      picture: () => pngOf(engine),
      save: () => this.run('save-project'),
    };
    const plain = this.linkOf(engine, {});
    showShare(
      { plain, withPhotos: plain.photosLeft > 0 ? await this.shareLink({ photos: true }) : null },
      host,
      storedSection(() => this.modelFile()),
    );
  }

  private linkOf(engine: Engine, copies: Record<string, string>): SharedLink {
    return sharedLink(engine.shareText(copies));
  }

  /** The open model as a link that holds it; with `photos` with small copies of its photos. */
  async shareLink({ photos = false } = {}): Promise<SharedLink> {
    const engine = this.engine;
    if (!engine) throw new Failure('NotReady', 'The page is not ready yet. Wait for spineloft.ready.');
    return this.linkOf(engine, photos ? await photoCopies(engine) : {});
  }

  /** The open model as a file with its photos, and its name. */
  private async modelFile(): Promise<{ name: string; bytes: Uint8Array }> {
    const bytes = await window.spineloft.exportModel('spineloft');
    return { name: this.engine!.about().name, bytes };
  }

  /** The open model under a short link, on the server of this host. */
  async storeLink(): Promise<SharedLink> {
    const { name, bytes } = await this.modelFile();
    return asSharedLink(await storeModel(name, bytes));
  }

  /** Id of the open model in the list; null while it is empty and new. */
  get currentModel(): string | null {
    return this.keeper?.current ?? null;
  }

  /** Opens the model in a link as a new one; rejects when there is none, and then nothing has changed. */
  async openLink(link: string): Promise<void> {
    const stored = serverLinkIn(link);
    return this.openProject(new Blob(stored ? [(await readStored(stored)) as BlobPart] : [link]));
  }

  async takeBackLink(text: string): Promise<void> {
    await takeBack(serverLinkIn(text)?.id ?? '');
  }

  /** Files that the visitor dropped, pasted or chose, one after the other. */
  async openFiles(files: File[]): Promise<void> {
    for (const file of files) {
      try {
        const isModel = /\.(spineloft|glb)$/i.test(file.name) || (await isModelFile(file));
        await (isModel ? this.openProject(file) : this.openImage(file, file.name || 'Pasted picture', true));
        this.canvas.focus({ preventScroll: true });
      } catch (thrown) {
        this.complain(thrown);
      }
    }
  }

  /** Opens one of the samples; the first one brings its ghost hand along. */
  async openSample(sample: Sample, address: string, withGhost: boolean): Promise<void> {
    try {
      const response = await fetch(address);
      if (!response.ok)
        throw new Failure('FileUnreadable', 'The sample picture did not load. Check the connection and try again.');
      await this.openImage(await response.blob(), t(sample.title), true);
      this.guide.offer(withGhost ? sample : null);
      this.canvas.focus({ preventScroll: true });
      this.refresh();
    } catch (thrown) {
      this.complain(thrown);
    }
  }

  /** What is begun on the start page is a model of its own where the open one has steps that can be done again. */
  private async leaveUndone(): Promise<void> {
    if (this.isOnStartPage && this.view && this.view.redo > 0) await this.keeper?.newModel();
  }

  /** A blank sheet, with the pen in hand. */
  async drawOnPaper(): Promise<void> {
    try {
      await this.leaveUndone();
      this.run('new-sketch');
      this.refresh();
      this.canvas.focus({ preventScroll: true });
    } catch (thrown) {
      this.complain(thrown);
    }
  }

  complain(thrown: unknown): void {
    if (thrown instanceof Failure && thrown.code === 'Cancelled') toast(thrown.message);
    else toast(sentenceOf(thrown), 'error');
  }

  private keep(what: string, id: string): void {
    this.keeper?.handle({ type: 'keep', what, id });
  }

  private setReadOnly(readOnly: boolean): void {
    this.readOnly = readOnly;
    document.body.dataset.locked = String(readOnly);
    byId('bar').inert = readOnly;
    this.refresh();
  }

  private async mayLose(needless: AbortSignal): Promise<boolean> {
    const answer = await askChoice(
      'This model is not kept',
      'This device does not keep the model that is open. Save a file of it first, or it will be gone.',
      [
        { value: 'save', label: 'Save a file', command: 'save-project' },
        { value: 'leave', label: 'Let it go' },
      ],
      needless,
    );
    if (answer === 'save') this.run('save-project');
    return answer === 'leave';
  }

  private async ask(event: Extract<EngineEvent, { type: 'ask' }>): Promise<void> {
    const command = event.id.split(':')[0]!;
    const isOne = this.table.some(({ id }) => id === command);
    const text = event.at
      ? await askInPlace(event.at, event.text, event.value ?? '')
      : await askText(event.title, event.text, event.value, isOne ? command : undefined);
    if (text !== null) this.engine?.answer(event.id, text);
  }

  private showProgress(): void {
    // Every stroke on paper has its edges looked for; nobody who draws needs to know.
    const drawing = this.view?.tool === 'pen' || this.view?.tool === 'eraser';
    const activity = drawing ? null : (this.view?.activity ?? null);
    if (this.opening.size > 0) {
      const cancel = () => this.opening.forEach((aborter) => aborter.abort());
      this.progress.set({ label: 'Opening the picture', done: null, cancel });
    } else if (activity) {
      const cancel = () => this.engine?.cancelWork();
      // Without threads the page stands still while it works: it says so before, not after.
      this.progress.set({ label: activity.label, done: activity.done, cancel }, !wantsThreads());
    } else {
      this.progress.set(null);
    }
  }

  /** Brings the DOM in step with what the engine told. */
  refresh(view = this.engine?.view): void {
    if (!this.engine || !view) return;
    if (!this.readOnly && isSolidLikely(this.view, view)) startSolver(this.engine);
    if (!this.readOnly && isCutOutLikely(this.view, view)) startCutter(this.engine);
    this.view = view;
    if (this.passing !== null && this.passing !== placeOf(view)) this.say('');
    const hasPicture = view.picture !== null;
    document.body.dataset.stage = hasPicture ? 'work' : 'start';
    const start = byId('start');
    const comesBack = start.hidden && !hasPicture;
    start.hidden = hasPicture;
    if (comesBack) start.scrollTop = 0;
    // A board that was emptied can still be undone.
    byId('bar').hidden = !hasPicture && view.undo + view.redo === 0;
    this.home.disabled = !hasPicture;
    setAttribute(this.home, 'title', hasPicture ? 'Home: the start page, with your models' : null);
    byId('home-word').textContent = hasPicture ? t('Home') : 'SpineLoft';
    this.canvas.inert = !hasPicture || this.readOnly;
    byId('mirror').hidden = !hasPicture || this.readOnly;
    void this.models.update();
    const commands = commandsNow(this.table, view);
    this.tools.see(commands.find(({ id }) => id === 'more-tools')?.toggled === true);
    this.bar.update(commands);
    this.coach.tell(this.guide.update(view, this.coach.next(view, commands)));
    byId('status-end').textContent = hasPicture ? summary(view) : '';
    this.showProgress();
  }

  /** True when closing the page would lose something: work that is neither in a file nor kept on this device. */
  get hasUnsavedWork(): boolean {
    return this.engine !== null && this.keeper?.isSafe !== true && this.engine.view.unsaved;
  }
}

/** Changes with whatever the visitor does to the model, or takes in hand. */
function placeOf({ undo, redo, selected, tool }: ShellView): string {
  return [undo, redo, selected?.id, tool].join();
}

function summary({ parts, selected }: ShellView): string {
  if (parts === 0) return t('No part yet');
  const count = parts === 1 ? t('1 part') : t('{n} parts', { n: parts });
  return selected ? `${count} · ${nameText(selected.name)}` : count;
}
