// What to do next, one sentence in the status line: the first visit's steps, those of a task that Help began, or advice that
// has no room beside the picture. It can be closed for good, and is silent while the page asks something.
import type { Command } from './api.ts';
import { byId } from './dom.ts';
import { icon } from './icons.ts';
import type { ShellView } from './shell_view.ts';
import type { Example } from './task_drawings.ts';
import { kFirstVisit, Steps } from './tasks.ts';
import type { Task } from './tasks.ts';
import { isAsked, onToasts } from './toasts.ts';
import { t } from './words/words.ts';

const kClosed = 'spineloft.coach';

/** How long a sentence at the foot is new, milliseconds: time to read two lines. */
export const kNewMs = 6000;

/** A step as it is told. */
export interface Advised {
  words: string;
  /** What the ghost hand shows. */
  example: Example | null;
}

/** Commands that answer a question which is open on the canvas while they can be run. */
const kAnswers = ['hollow-use', 'cut-use'];

/** The tools that the first visit's steps are about: with another one in hand they say nothing. */
const kFirstTools = ['draw', 'hand', 'puff', 'sheet', 'pen', 'eraser'];

export class Coach {
  private readonly line = byId('coach');
  private readonly words = byId('coach-words');
  private steps: Steps | null = null;
  private task: Task | null = null;
  private isWanted = readWanted();
  private isTold = false;
  private since = -Infinity;

  /** Whether nobody can have read yet what is told. */
  get isNew(): boolean {
    return this.isTold && performance.now() - this.since < kNewMs;
  }

  constructor() {
    byId('coach-close').append(icon('x'));
    byId('coach-close').addEventListener('click', () => this.end());
    this.line.prepend(icon('lightbulb'));
    onToasts(() => this.show());
  }

  /** Leads through a task, or once more through the first visit. */
  begin(task: Task | null): void {
    this.task = task;
    this.steps = null;
    this.isWanted = true;
    keepWanted(true);
  }

  /** Follows what is done; the first visit's steps begin with its first part. What to do next, null where nothing is to be said. */
  next(view: ShellView, commands: readonly Command[]): Advised | null {
    if (!view.picture || !this.isWanted || (!this.task && view.parts === 0)) {
      if (!view.picture) this.steps = null;
      return null;
    }
    if (!this.task && !kFirstTools.includes(view.tool)) return null;
    this.steps ??= new Steps(this.task?.steps ?? kFirstVisit, view);
    const step = this.steps.next(view);
    if (step === null) {
      if (this.steps.areDone) this.end();
      return null;
    }
    const asked = commands.find(({ id, enabled }) => enabled && kAnswers.includes(id));
    if (asked && asked.id !== step.answers) return null;
    const words = t('{step} ({n} of {all})', {
      step: t(step.say),
      n: this.steps.place(step),
      all: this.steps.steps.length,
    });
    const { examples = [] } = step;
    return { words, example: examples[Math.min(Math.max(view.parts - 1, 0), examples.length - 1)] ?? null };
  }

  /** Tells this in the status line; null: nothing is to be told there. */
  tell(step: Advised | null): void {
    this.isTold = step !== null && this.isWanted;
    if (step && this.words.textContent !== step.words) {
      this.words.textContent = step.words;
      this.since = performance.now();
      byId('status').removeAttribute('data-new'); // where one line has room for one of the two
    }
    this.show();
  }

  private show(): void {
    this.line.hidden = !this.isTold || isAsked();
  }

  private end(): void {
    this.isWanted = false;
    this.task = null;
    this.tell(null);
    keepWanted(false);
  }
}

function readWanted(): boolean {
  try {
    return localStorage.getItem(kClosed) !== 'closed';
  } catch {
    return true; // a browser that keeps nothing
  }
}

function keepWanted(wanted: boolean): void {
  try {
    if (wanted) localStorage.removeItem(kClosed);
    else localStorage.setItem(kClosed, 'closed');
  } catch {
    // It is asked again next time.
  }
}
