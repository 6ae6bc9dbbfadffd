// The start page: one big drop area, a button, and six pictures to try; the first shows how it is done.
import samples from '../../assets/samples/samples.json';
import { asIs, byId, kIsMac, make, shortcutText } from './dom.ts';
import { pickPicture } from './files.ts';
import { ghostHand } from './ghost_hand.ts';
import { icon } from './icons.ts';
import { onLanguage, t } from './words/words.ts';

export interface Sample {
  id: string;
  file: string;
  title: string;
  alt: string;
  width: number;
  height: number;
  credit: string;
  licence: string;
  licenceUrl: string;
  source: string;
  sourceUrl: string;
  changes: string;
  /** What to keep in view when the card crops the picture (CSS object-position; of the first sample: middle or bottom). */
  focus: string;
  /** A line that works, in picture pixels: for the ghost hand and for tests. */
  spine: [number, number][];
}

export const kSamples = samples as unknown as Sample[];

function assetAddress(name: string): string {
  return new URL(SPINELOFT_SITE.assets[name] ?? '', document.baseURI).href;
}

/** Address of a sample's picture on this site. */
export function sampleAddress(sample: Sample): string {
  return assetAddress(`samples/${sample.file}`);
}

/** The same picture as small as its card needs it: the first visit waits for no more. */
function cardAddress(sample: Sample): string {
  return assetAddress(`samples/cards/${sample.file.replace(/\.\w+$/, '.webp')}`);
}

const kBottom = '50% 100%';

function card(sample: Sample, isFirst: boolean, open: (sample: Sample) => void): HTMLElement {
  const isDrawing = sample.file.endsWith('.png');
  const picture = make('img', {
    src: cardAddress(sample),
    alt: sample.alt,
    width: String(sample.width),
    height: String(sample.height),
    decoding: 'async',
  });
  const frame = make('span', { class: 'sample-frame' }, picture);
  const button = make(
    'button',
    { type: 'button', class: 'sample-open' },
    frame,
    make('span', { class: 'sample-title' }, sample.title),
  );
  button.addEventListener('click', () => open(sample));
  const credit = make(
    'p',
    { class: 'sample-credit' },
    make('a', { href: sample.sourceUrl, target: '_blank', rel: 'noopener noreferrer' }, sample.credit),
    ' · ',
    make('a', { href: sample.licenceUrl, target: '_blank', rel: 'noopener noreferrer' }, sample.licence),
  );
  picture.style.objectPosition = sample.focus;
  if (isFirst) addGhost(sample, frame, picture, button);
  return make('li', { class: isDrawing ? 'sample sample-drawing' : 'sample' }, button, credit);
}

function addGhost(sample: Sample, frame: HTMLElement, picture: HTMLImageElement, button: HTMLElement): void {
  button.append(make('span', { class: 'sample-badge' }, 'Start here'));
  const show = () => {
    const scale = Math.min(
      sample.width / Math.max(1, frame.clientWidth),
      sample.height / Math.max(1, frame.clientHeight),
    );
    const ghost = ghostHand(sample, scale);
    // As object-fit: cover and object-position do with the picture.
    ghost.element.setAttribute('preserveAspectRatio', `xMidY${sample.focus === kBottom ? 'Max' : 'Mid'} slice`);
    frame.append(ghost.element);
    ghost.play();
    button.addEventListener('pointerenter', ghost.play);
    button.addEventListener('focus', ghost.play);
  };
  if (picture.complete) requestAnimationFrame(show);
  else picture.addEventListener('load', show, { once: true });
}

/** The sentence with its keys, wherever a language puts them. */
function showPasteHint(): void {
  const [before = '', after = ''] = t('or paste one with {keys}', { keys: '\n' }).split('\n');
  byId('paste-hint').replaceChildren(before, make('kbd', {}, asIs(kIsMac ? '⌘V' : shortcutText('Ctrl+V'))), after);
}

/** Fills the start page and connects its buttons. */
export function buildStartPage(open: (sample: Sample) => void, drawOnPaper: () => void, help: () => void): void {
  byId('samples').replaceChildren(...kSamples.map((sample, i) => card(sample, i === 0, open)));
  byId('choose').prepend(icon('image-plus'));
  byId('choose').addEventListener('click', pickPicture);
  byId('camera').prepend(icon('camera'));
  byId('camera').addEventListener('click', () => byId('camera-picker').click());
  byId('paper').prepend(icon('square-pen'));
  byId('paper').addEventListener('click', drawOnPaper);
  byId('things').prepend(icon('lightbulb'));
  byId('things').addEventListener('click', help);
  byId('privacy').prepend(icon('shield-check'));
  showPasteHint();
  onLanguage(showPasteHint);
}
