// Banners: what stays true until something is done about it, above the stage, with buttons to do it.
import { byId, make } from './dom.ts';
import { icon } from './icons.ts';

export interface Banner {
  /** A banner of the same id takes its place. */
  id: string;
  text: string;
  /** With the command of the table that one runs, if it does. */
  actions: { label: string; command?: string; run(): void }[];
  canDismiss: boolean;
}

export function hideBanner(id: string): void {
  byId('banners').querySelector(`[data-id="${id}"]`)?.remove();
}

export function showBanner(banner: Banner): void {
  hideBanner(banner.id);
  const element = make(
    'div',
    { class: 'banner', role: 'alert', 'data-id': banner.id },
    icon('triangle-alert'),
    make('p', {}, banner.text),
  );
  const buttons = make('div', { class: 'banner-buttons' });
  for (const action of banner.actions) {
    const button = make('button', { type: 'button', class: 'button', 'data-command': action.command }, action.label);
    button.addEventListener('click', () => action.run());
    buttons.append(button);
  }
  if (banner.canDismiss) {
    const close = make('button', { type: 'button', class: 'toast-close', 'aria-label': 'Dismiss' });
    close.append(icon('x'));
    close.addEventListener('click', () => element.remove());
    buttons.append(close);
  }
  element.append(buttons);
  byId('banners').append(element);
}
