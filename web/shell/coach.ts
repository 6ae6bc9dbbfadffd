// What to do next, one sentence in the status line: the first visit's steps, or those of a task that Help began. It is
// never over the drawing, and can be closed for good.
import { byId } from './dom.ts';
import { icon } from './icons.ts';
import type { ShellView } from './shell_view.ts';
import { kFirstVisit, Steps } from './tasks.ts';
import type { Task } from './tasks.ts';
import { t } from './words/words.ts';

const kClosed = 'spineloft.coach';

export class Coach {
  private readonly line = byId('coach');
  private readonly words = byId('coach-words');
  private steps: Steps | null = null;
  private task: Task | null = null;
  private isWanted = readWanted();

  constructor() {
    byId('coach-close').append(icon('x'));
    byId('coach-close').addEventListener('click', () => this.end());
    this.line.prepend(icon('lightbulb'));
  }

  /** Leads through a task, or once more through the first visit. */
  begin(task: Task | null): void {
    this.task = task;
    this.steps = null;
    this.isWanted = true;
    keepWanted(true);
  }

  /** Follows what is done; the first visit's steps begin with its first part. */
  update(view: ShellView): void {
    if (!view.picture || !this.isWanted || (!this.task && view.parts === 0)) {
      this.line.hidden = true;
      if (!view.picture) this.steps = null;
      return;
    }
    this.steps ??= new Steps(this.task?.steps ?? kFirstVisit, view);
    const step = this.steps.next(view);
    if (step === null) {
      this.end();
      return;
    }
    this.line.hidden = false;
    const { done, all } = this.steps.count;
    const words = t('{step} ({n} of {all})', { step: t(step.say), n: done + 1, all });
    if (this.words.textContent !== words) this.words.textContent = words;
  }

  private end(): void {
    this.isWanted = false;
    this.task = null;
    this.line.hidden = true;
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
