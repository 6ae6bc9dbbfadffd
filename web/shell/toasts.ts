// Toasts: what happened and what to do, stacked at the bottom, dismissable, read out by screen readers.
import { byId, make } from './dom.ts';
import { icon } from './icons.ts';

export type ToastLevel = 'info' | 'error';

const kMs: Record<ToastLevel, number> = { info: 4500, error: 9000 };
const kMost = 4;

/** Shows a toast; the same text again only restarts its time. */
export function toast(text: string, level: ToastLevel = 'info'): void {
  const stack = byId('toasts');
  for (const old of [...stack.children]) {
    if ((old as HTMLElement).dataset.text === text) old.remove();
  }
  while (stack.children.length >= kMost) stack.firstElementChild?.remove();
  const close = make('button', { type: 'button', class: 'toast-close', 'aria-label': 'Dismiss' });
  close.append(icon('x'));
  const element = make('div', { class: `toast toast-${level}`, role: level === 'error' ? 'alert' : 'status' },
    icon(level === 'error' ? 'circle-alert' : 'circle-check'), make('p', {}, text), close);
  element.dataset.text = text;
  stack.append(element);
  let timer = 0;
  const stop = () => clearTimeout(timer);
  const start = () => {
    stop();
    timer = window.setTimeout(() => element.remove(), kMs[level]);
  };
  close.addEventListener('click', () => element.remove());
  // Reading takes the time it takes: the clock stands still under the pointer and while focused.
  element.addEventListener('pointerenter', stop);
  element.addEventListener('pointerleave', start);
  element.addEventListener('focusin', stop);
  element.addEventListener('focusout', start);
  start();
}
