// The dialog Share: the model as a link and a QR code, as a picture, on stickers, and on another page.
import type { SharedLink } from './api.ts';
import { openDialog } from './dialogs.ts';
import { asIs, make } from './dom.ts';
import { sentenceOf } from './failure.ts';
import { download } from './files.ts';
import { icon } from './icons.ts';
import { viewAddress } from './links.ts';
import { qrCode } from './qr.ts';
import { printCopies } from './stickers.ts';
import { toast } from './toasts.ts';
import { t } from './words/words.ts';

/** Longest link that most programs keep whole, and that is read well from a QR code on a screen. */
const kMostCharacters = 1900;

/** What the dialog needs of the page. */
export interface ShareHost {
  name: string;
  /** A square picture of the model on a canvas; null while there is nothing to show. */
  still(side: number): HTMLCanvasElement | null;
  /** The picture with the model inside; null while there is nothing to show. */
  picture(): Promise<Uint8Array | null>;
  /** Saves a model file. */
  save(): void;
}

export function sharedLink({ text, photos }: { text: string; photos: number }): SharedLink {
  return { url: viewAddress(text), text, characters: text.length, photosLeft: photos, stored: false };
}

type TextField = HTMLInputElement | HTMLTextAreaElement;

/** Without https the clipboard can only be reached by what is marked. */
export async function copyField(field: TextField, said: string): Promise<void> {
  field.select();
  try {
    await navigator.clipboard.writeText(field.value);
  } catch {
    if (!document.execCommand('copy')) return toast('Press Ctrl+C to copy it.');
  }
  toast(said);
}

function button(name: string, text: string, act: () => void, look = ''): HTMLButtonElement {
  const made = make('button', { type: 'button', class: `button ${look}` });
  made.append(icon(name), ' ', make('span', {}, text));
  made.addEventListener('click', act);
  return made;
}

function selectWhole(field: TextField): void {
  field.addEventListener('focus', () => field.select());
}

/** Sides of the picture on a sticker and of the poster of an embedded viewer, pixels. */
const kStickerSide = 200,
  kPosterSide = 240;

/** Hands the picture to the system's share sheet where it takes files, else saves it. */
async function sendPicture(host: ShareHost): Promise<void> {
  const bytes = await host.picture();
  if (!bytes) return toast('There is nothing to show yet. Draw a line through something first.', 'error');
  const file = new File([bytes as BlobPart], `${host.name}.png`, { type: 'image/png' });
  if (navigator.canShare?.({ files: [file] })) {
    try {
      return await navigator.share({ files: [file] });
    } catch (thrown) {
      if ((thrown as Error).name === 'AbortError') return; // the visitor closed it
    }
  }
  download(file.name, file.type, bytes);
  toast(t('Saved {file}.', { file: file.name }));
}

const escaped = (text: string) => text.replace(/[&"<>]/g, (letter) => `&#${letter.charCodeAt(0)};`);

/** The HTML that shows the model inside another page: its picture first, and the viewer when that is pressed. */
export function snippetOf(url: string, host: Pick<ShareHost, 'name' | 'still'>): string {
  const poster = host.still(kPosterSide)?.toDataURL('image/webp', 0.7) ?? '';
  const address = poster.startsWith('data:image/webp') ? `${url}&poster=${poster}` : url;
  return (
    `<iframe src="${escaped(address)}" title="${escaped(host.name)}" width="480" height="360" ` +
    `style="border: 0; max-width: 100%" loading="lazy" allow="fullscreen; xr-spatial-tracking"></iframe>`
  );
}

/** A part of the dialog that opens when it is pressed. */
function onAPage(url: string, host: ShareHost): HTMLElement {
  const field = make('textarea', { id: 'share-snippet', readonly: '', rows: '4', spellcheck: 'false' });
  selectWhole(field);
  const fold = make(
    'details',
    { class: 'share-fold' },
    make('summary', {}, 'On your own page'),
    make('label', { for: 'share-snippet' }, 'Put this into the HTML of the page'),
    field,
    make(
      'div',
      { class: 'dialog-buttons' },
      button('copy', 'Copy', () => void copyField(field, 'The HTML is copied.')),
    ),
  );
  // The picture in it takes a moment to make.
  fold.addEventListener('toggle', () => {
    if (fold.open && field.value === '') field.value = snippetOf(url, host);
  });
  return fold;
}

/** The links of a model. */
export interface ModelLinks {
  plain: SharedLink;
  /** With small copies of its photos; null where it has none. */
  withPhotos: SharedLink | null;
}

const isLong = ({ characters }: SharedLink) => characters > kMostCharacters;

/** What else to send in place of a link that is too long: a short link where the host keeps models, else the rest. */
function instead({ plain }: ModelLinks, link: SharedLink, hasServer: boolean): HTMLElement {
  const said = [t('This link is {n} characters long, and some programs cut it off.', { n: link.characters })];
  if (!isLong(plain)) said.push(t('Without the photos it is short, and there is a QR code of it.'));
  said.push(
    hasServer
      ? t('Make a short link below, or send the picture or the model file: the whole model is in each of them.')
      : t('Or send the picture or the model file: the whole model is in both.'),
  );
  return make('p', { class: 'share-long' }, asIs(said.join(' ')));
}

/** Link, QR code and what is made of the link. */
function linkPart(links: ModelLinks, link: SharedLink, host: ShareHost, hasServer: boolean): Node[] {
  const { url } = link;
  const field = make('input', { type: 'text', id: 'share-link', readonly: '', value: url });
  selectWhole(field);
  const long = isLong(link);
  const buttons = make('div', { class: 'dialog-buttons' });
  if (typeof navigator.share === 'function')
    buttons.append(button('send', 'Send', () => void navigator.share({ url }).catch(() => undefined)));
  const copy = () => void copyField(field, 'The link is copied.');
  buttons.append(button('copy', 'Copy link', copy, long ? '' : 'button-primary'));
  const send = () => void sendPicture(host).catch((thrown: unknown) => toast(sentenceOf(thrown), 'error'));
  const others = make('div', { class: 'share-others' });
  others.append(button('image-down', 'Picture', send, long ? 'button-primary' : ''));
  if (long) others.append(button('save', 'Save model', () => host.save()));
  else {
    const print = () => {
      const src = host.still(kStickerSide)?.toDataURL();
      const picture = () => (src ? make('img', { src, alt: '' }) : null);
      void printCopies({ url, name: host.name, maker: null, picture });
    };
    others.append(button('qr-code', 'Stickers', print));
  }
  const pictureHasAll =
    'The picture has the model inside, with its photos: who drops it on this page can go on with it.';
  return [
    make('label', { for: 'share-link' }, 'Link'),
    field,
    buttons,
    long ? instead(links, link, hasServer) : qrCode(url).svg,
    make('p', { class: 'share-more' }, pictureHasAll),
    others,
    onAPage(url, host),
  ];
}

/** The dialog with the link of the model; `more` comes below it, where the host has a server. */
export function showShare(links: ModelLinks, host: ShareHost, more: Promise<HTMLElement | null>): void {
  const { plain, withPhotos } = links;
  const part = make('div', {});
  const photos = make('input', { type: 'checkbox', id: 'share-photos' });
  // A photo goes along by itself where the link stays short.
  photos.checked = withPhotos !== null && !isLong(withPhotos);
  const left = make('p', { class: 'share-more' });
  let hasServer = false;
  const draw = () => {
    const link = photos.checked && withPhotos ? withPhotos : plain;
    part.replaceChildren(...linkPart(links, link, host, hasServer));
    left.textContent =
      link.photosLeft > 0 ? t('Photos stay here: the parts keep their shape and get one colour each.') : '';
  };
  photos.addEventListener('change', draw);
  const choice = make('label', { class: 'share-photos', for: 'share-photos' }, photos, ' ');
  choice.append(make('span', {}, 'With small copies of the photos'));
  draw();
  const body: Node[] = [
    make('p', {}, 'The whole model is in this link. Who opens it sees it and can have a copy; yours stays as it is.'),
    ...(withPhotos ? [choice, left] : []),
    part,
  ];
  const dialog = openDialog('Share', body, 'dialog share');
  void more.then((section) => {
    if (!section) return;
    hasServer = true;
    dialog.append(section);
    dialog.querySelector('.share-long')?.replaceWith(instead(links, photos.checked ? withPhotos! : plain, true));
  });
  part.querySelector('input')!.select();
}
