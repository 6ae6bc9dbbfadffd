// The model as a link: its text stands behind the '#' of the page's own address, which browsers send to no server.
import { create } from 'qrcode/lib/core/qrcode.js';
import type { SharedLink } from './api.ts';
import { openDialog } from './dialogs.ts';
import { make } from './dom.ts';
import { icon } from './icons.ts';
import { toast } from './toasts.ts';
import { t } from './words/words.ts';

/** What stands in front of the text; the engine knows it too (io/share_text.h). */
const kMark = '#m=';

/** Longest link that most programs keep whole, and that is read well from a QR code on a screen. */
const kMostCharacters = 1900;

/** Modules of white round a QR code (ISO/IEC 18004). */
const kQuiet = 4;

export function sharedLink({ text, photos }: { text: string; photos: number }): SharedLink {
  const url = location.origin + location.pathname + kMark + text;
  return { url, text, characters: text.length, photosLeft: photos, stored: false };
}

/** The link in the page's address, which is taken out of it: loading the page again must not open the model again. */
export function takeLink(): string | null {
  if (!location.hash.startsWith(kMark)) return null;
  const link = location.hash;
  history.replaceState(null, '', location.pathname + location.search);
  return link;
}

/** Black on white in any theme, so that every camera reads it. */
export function qrCode(text: string): SVGElement {
  const { size, data } = create(text, { errorCorrectionLevel: 'L' }).modules;
  const rows = Array.from({ length: size }, (_, y) =>
    Array.from(data.subarray(y * size, (y + 1) * size), (dark, x) => (dark ? `M${x} ${y}h1v1h-1z` : '')).join(''),
  );
  const side = size + 2 * kQuiet;
  const holder = document.createElement('template');
  holder.innerHTML =
    `<svg viewBox="${-kQuiet} ${-kQuiet} ${side} ${side}" shape-rendering="crispEdges" role="img">` +
    `<path fill="#fff" d="M${-kQuiet} ${-kQuiet}h${side}v${side}h${-side}z"/><path d="${rows.join('')}"/></svg>`;
  const svg = holder.content.querySelector('svg') as SVGElement;
  svg.setAttribute('class', 'share-code');
  svg.setAttribute('aria-label', t('QR code of the link'));
  return svg;
}

/** Without https the clipboard can only be reached by what is marked. */
export async function copyField(field: HTMLInputElement): Promise<void> {
  field.select();
  try {
    await navigator.clipboard.writeText(field.value);
  } catch {
    if (!document.execCommand('copy')) return toast('Press Ctrl+C to copy the link.');
  }
  toast('The link is copied.');
}

function button(name: string, text: string, act: () => void, look = ''): HTMLButtonElement {
  const made = make('button', { type: 'button', class: `button ${look}` });
  made.append(icon(name), ' ', make('span', {}, text));
  made.addEventListener('click', act);
  return made;
}

/** The dialog with the link of the model; `more` comes below it, where there is something. */
export function showShare({ url, characters, photosLeft }: SharedLink, more: Promise<HTMLElement | null>): void {
  const field = make('input', { type: 'text', id: 'share-link', readonly: '', value: url });
  field.addEventListener('focus', () => field.select());
  const buttons = make('div', { class: 'dialog-buttons' });
  if (typeof navigator.share === 'function') {
    buttons.append(button('send', 'Send', () => void navigator.share({ url }).catch(() => undefined)));
  }
  buttons.append(button('copy', 'Copy link', () => void copyField(field), 'button-primary'));
  const isLong = characters > kMostCharacters;
  const body: Node[] = [
    make('p', {}, 'The whole model is in this link. Who opens it gets a copy; yours stays as it is.'),
    ...(photosLeft > 0 ? [make('p', {}, 'Photos stay here: the parts keep their shape and get one colour each.')] : []),
    make('label', { for: 'share-link' }, 'Link'),
    field,
    buttons,
    isLong
      ? make(
          'p',
          {},
          t('This link is {n} characters long, and some programs cut it off. A model file is safer.', {
            n: characters,
          }),
        )
      : qrCode(url),
  ];
  const dialog = openDialog('Share', body, 'dialog share');
  void more.then((section) => section && dialog.append(section));
  field.select();
}
