// The page around the running engine: keeps the DOM in step with the document.
import type { State } from './api.ts';
import { CommandBar } from './command_bar.ts';
import { askText, showShortcutSheet } from './dialogs.ts';
import { byId } from './dom.ts';
import type { Engine, EngineEvent } from './engine.ts';
import { Failure, sentenceOf } from './failure.ts';
import { download, pickPicture } from './files.ts';
import { Guide } from './guide.ts';
import { decodePicture } from './picture.ts';
import { ProgressBar } from './progress.ts';
import { keepShelf, readShelf, watchShelf } from './shelf.ts';
import type { Sample } from './start_page.ts';
import { toast } from './toasts.ts';

export class Page {
  private engine: Engine | null = null;
  private state: State | null = null;
  private readonly opening = new Set<AbortController>();
  private readonly canvas = byId<HTMLCanvasElement>('canvas');
  private readonly bar: CommandBar;
  private readonly progress = new ProgressBar();
  private readonly guide = new Guide();

  constructor() {
    this.bar = new CommandBar((id, args) => this.run(id, args), () => this.showShortcuts());
  }

  /** The engine runs: from now on the DOM follows it. */
  attach(engine: Engine): void {
    this.engine = engine;
    engine.run('load-shelf', { slices: readShelf() });
    watchShelf((slices) => this.run('load-shelf', { slices }));
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
    return this.opening.size > 0;
  }

  get isOnStartPage(): boolean {
    return this.state?.picture == null;
  }

  handle(event: EngineEvent): void {
    switch (event.type) {
      case 'changed': this.refresh(); break;
      case 'toast': toast(event.text, event.level); break;
      case 'file':
        download(event.name, event.mediaType, event.bytes);
        this.engine?.markSaved();
        toast(`Saved ${event.name}.`);
        break;
      case 'pickPicture': pickPicture(); break;
      case 'ask': void this.ask(event); break;
      case 'cursor': this.canvas.style.cursor = event.css; break;
      case 'shelf': keepShelf(event.slices); break;
      case 'status': this.say(event.text); break;
    }
  }

  /** Runs a command for the visitor; a refusal becomes a toast. */
  run(id: string, args?: Record<string, unknown>): void {
    try {
      this.engine?.run(id, args);
    } catch (thrown) {
      toast(sentenceOf(thrown), 'error');
    }
  }

  showShortcuts(): void {
    if (this.engine) showShortcutSheet(this.engine.commands());
  }

  say(text: string): void {
    byId('status').textContent = text;
  }

  /** Decodes and opens one picture; rejects when it cannot be opened, and then nothing has changed. */
  async openImage(blob: Blob, name: string): Promise<void> {
    const engine = this.engine;
    if (!engine) throw new Failure('NotReady', 'The page is not ready yet. Wait for spineloft.ready.');
    const aborter = new AbortController();
    this.opening.add(aborter);
    this.showProgress();
    try {
      const picture = await decodePicture(blob, (code) => engine.sentence(code));
      if (aborter.signal.aborted) throw new Failure('Cancelled', engine.sentence('Cancelled'));
      engine.addPicture(picture, name);
      this.say(`${name} is open: ${picture.originalWidth} by ${picture.originalHeight} pixels.`);
    } finally {
      this.opening.delete(aborter);
      this.refresh();
    }
  }

  /** Files that the visitor dropped, pasted or chose, one after the other. */
  async openFiles(files: File[]): Promise<void> {
    for (const file of files) {
      try {
        await this.openImage(file, file.name || 'Pasted picture');
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
      if (!response.ok) throw new Failure('FileUnreadable', 'The sample picture did not load. Check the connection and try again.');
      await this.openImage(await response.blob(), sample.title);
      this.guide.offer(withGhost ? sample : null);
      this.canvas.focus({ preventScroll: true });
      this.refresh();
    } catch (thrown) {
      this.complain(thrown);
    }
  }

  /** A blank sheet, with the pen in hand. */
  drawOnPaper(): void {
    this.run('new-sketch');
    this.refresh();
    this.canvas.focus({ preventScroll: true });
  }

  private complain(thrown: unknown): void {
    if (thrown instanceof Failure && thrown.code === 'Cancelled') toast(thrown.message);
    else toast(sentenceOf(thrown), 'error');
  }

  private async ask(event: Extract<EngineEvent, { type: 'ask' }>): Promise<void> {
    const text = await askText(event.title, event.text, event.value);
    if (text !== null) this.engine?.answer(event.id, text);
  }

  private showProgress(): void {
    // Every stroke on paper has its edges looked for; nobody who draws needs to know.
    const drawing = this.state?.tool === 'pen' || this.state?.tool === 'eraser';
    const activity = drawing ? null : this.state?.activity ?? null;
    if (this.isBusy) {
      const cancel = () => this.opening.forEach((aborter) => aborter.abort());
      this.progress.set({ label: 'Opening the picture', done: null, cancel });
    } else if (activity) {
      this.progress.set({ label: activity.label, done: activity.done, cancel: () => this.engine?.cancelWork() });
    } else {
      this.progress.set(null);
    }
  }

  private refresh(): void {
    if (!this.engine) return;
    this.state = this.engine.state();
    const { state } = this;
    const hasPicture = state.picture !== null;
    document.body.dataset.stage = hasPicture ? 'work' : 'start';
    byId('start').hidden = hasPicture;
    byId('bar').hidden = !hasPicture;
    this.canvas.inert = !hasPicture;
    this.bar.update(this.engine.commands());
    this.guide.update(state, (x, y) => this.engine!.imageToCanvas(x, y));
    byId('status-end').textContent = hasPicture ? summary(state) : '';
    this.showProgress();
  }

  /** True when closing the page would lose something. */
  get hasUnsavedWork(): boolean {
    return this.engine !== null && this.engine.state().unsaved;
  }
}

function summary(state: State): string {
  const count = state.parts.length;
  if (count === 0) return 'No part yet';
  const selected = state.parts.find((part) => part.id === state.selection);
  const parts = count === 1 ? '1 part' : `${count} parts`;
  return selected ? `${parts} · ${selected.name}: ${selected.ribs.length} ribs` : parts;
}
