// Progress of anything that takes longer than a blink, with a way to stop it.
import { byId } from './dom.ts';
import { t } from './words/words.ts';

const kBlinkMs = 200;

/** What is going on: words, share done (null = not known), and how to stop it. */
export interface Activity {
  label: string;
  done: number | null;
  cancel(): void;
}

export class ProgressBar {
  private readonly box = byId('progress');
  private readonly bar = byId<HTMLProgressElement>('progress-bar');
  private readonly label = byId('progress-label');
  private activity: Activity | null = null;
  private timer = 0;

  constructor() {
    byId('progress-cancel').addEventListener('click', () => this.activity?.cancel());
  }

  /** Shows the activity once it has lasted longer than a blink, or `atOnce`; null ends it. */
  set(activity: Activity | null, atOnce = false): void {
    this.activity = activity;
    if (!activity) {
      clearTimeout(this.timer);
      this.timer = 0;
      this.box.hidden = true;
      return;
    }
    const label = t(activity.label);
    if (this.label.textContent !== label) this.label.textContent = label;
    if (activity.done === null) this.bar.removeAttribute('value');
    else this.bar.value = activity.done;
    if (atOnce) this.box.hidden = false;
    this.timer ||= window.setTimeout(() => {
      this.box.hidden = false;
    }, kBlinkMs);
  }
}
