// Toasts: what happened and what to do, stacked at the bottom, dismissable, read out by screen readers.
import { byId, make } from './dom.ts';
import { icon } from './icons.ts';

export type ToastLevel = 'info' | 'hint' | 'warning' | 'error';

const kMs: Record<ToastLevel, number> = { info: 4500, hint: 6000, warning: 9000, error: 9000 };
const kIcon: Record<ToastLevel, string> = {
  info: 'circle-check',
  hint: 'lightbulb',
  warning: 'triangle-alert',
  error: 'circle-alert',
};
/** Who is to press a button needs longer. */
const kActionMs = 9000;
/** A slow reader's pace, and the moment before the eye is there. */
const kMsPerLetter = 70,
  kFirstMs = 1500;
const kMost = 4;

/** On screens as small as this toasts lie on the panel (styles/popups.css). */
const kOverPanel = '(max-width: 62.4375em)';

/** A button of a toast. */
export interface ToastAction {
  label: string;
  /** Id of the command that it runs. */
  command?: string;
  run(): void;
}

/** Another model is open: what is said of the one before goes, with what it offers. */
export function withdrawToasts(): void {
  for (const element of byId('toasts').querySelectorAll('[data-of-model]')) element.remove();
}

/** Whether a toast waits for an answer. */
export function isAsked(): boolean {
  return byId('toasts').querySelector('.toast-action') !== null;
}

/** Calls back when toasts come or go. */
export function onToasts(listener: () => void): void {
  new MutationObserver(listener).observe(byId('toasts'), { childList: true });
}

/**
 * Shows a toast; the same text again only restarts its time. What is to be done stands after what is only told: where there
 * is room for one, the last is shown.
 */
export function toast(text: string, level: ToastLevel = 'info', action?: ToastAction): void {
  show(text, level, action);
}

/** The same about the open model. */
export function toastOfModel(text: string, level: ToastLevel = 'info', action?: ToastAction): void {
  show(text, level, action).dataset.ofModel = '';
}

function show(text: string, level: ToastLevel, action?: ToastAction): HTMLElement {
  const stack = byId('toasts');
  for (const old of [...stack.children]) {
    if ((old as HTMLElement).dataset.text === text) old.remove();
  }
  while (stack.children.length >= kMost) stack.firstElementChild?.remove();
  const close = make('button', { type: 'button', class: 'toast-close', 'aria-label': 'Dismiss' });
  close.append(icon('x'));
  const element = make(
    'div',
    { class: `toast toast-${level}`, role: level === 'info' || level === 'hint' ? 'status' : 'alert' },
    icon(kIcon[level]),
    make('p', {}, text),
  );
  if (action) {
    const button = make(
      'button',
      { type: 'button', class: 'button toast-action', 'data-command': action.command },
      action.label,
    );
    button.addEventListener('click', () => {
      element.remove();
      action.run();
    });
    element.append(button);
  }
  element.append(close);
  element.dataset.text = text;
  const told = element.getAttribute('role') === 'status';
  stack.insertBefore(element, told ? stack.querySelector('[role=alert]') : null);
  let timer = 0;
  const stop = () => clearTimeout(timer);
  const start = () => {
    stop();
    timer = window.setTimeout(
      () => element.remove(),
      Math.max(action ? kActionMs : kMs[level], kFirstMs + kMsPerLetter * text.length),
    );
  };
  close.addEventListener('click', () => element.remove());
  // What is in the way goes when the hand goes on, once it could be read.
  const made = performance.now();
  const goOn = (event: PointerEvent) => {
    if (!element.isConnected) return document.removeEventListener('pointerdown', goOn, true);
    const isOld = performance.now() - made > kFirstMs;
    const isPressed = (event.target as Element).closest('.toast button') !== null;
    if (isOld && matchMedia(kOverPanel).matches && !isPressed) element.remove();
  };
  document.addEventListener('pointerdown', goOn, true);
  // Reading takes the time it takes: the clock stands still under the pointer and while focused.
  element.addEventListener('pointerenter', stop);
  element.addEventListener('pointerleave', start);
  element.addEventListener('focusin', stop);
  element.addEventListener('focusout', start);
  start();
  return element;
}
