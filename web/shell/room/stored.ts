// A model with a short link: encrypted here, kept by the share server until it expires or is taken back. This browser
// remembers the secrets of the links that it made.
import type { SharedLink } from '../api.ts';
import { asIs, make } from '../dom.ts';
import { Failure, sentenceOf } from '../failure.ts';
import { qrCode } from '../qr.ts';
import { copyField } from '../share.ts';
import { toast } from '../toasts.ts';
import { language, t } from '../words/words.ts';
import { serverLink } from './address.ts';
import { iconButton } from './faces.ts';
import { connected, hostInfo, reachableAddress } from './host.ts';
import { keepLinks, madeLinks } from './made_links.ts';
import type { MadeLink } from './made_links.ts';

const kDays = [7, 1, 30, 365];
const kDayMs = 86_400_000;
/** The server takes 8 MB, and encryption adds a little. */
const kMostBytes = 8_000_000;

/** Stores a model file under a short link for so many days. */
export async function storeModel(name: string, bytes: Uint8Array, days = kDays[0]!): Promise<MadeLink> {
  if (bytes.length > kMostBytes)
    throw new Failure('TooLarge', 'This model is too large for a short link. Save a file, and send that.');
  const { server } = await connected();
  const stored = await server.storeModel(bytes, days);
  const url = serverLink(new URL('view.html', await reachableAddress()).href, { kind: 'stored', ...stored });
  const link = { ...stored, name, url, until: Date.now() + days * kDayMs };
  keepLinks([...madeLinks(), link]);
  return link;
}

/** As `spineloft.shareLink` gives it. */
export function asSharedLink({ id, key, url }: MadeLink): SharedLink {
  const text = `${id}.${key}`;
  return { url, text, characters: text.length, photosLeft: 0, stored: true };
}

/** Deletes what is stored under a link that was made here. */
export async function takeBack(id: string): Promise<void> {
  const links = madeLinks();
  const link = links.find((one) => one.id === id);
  if (!link) throw new Failure('NotThere', 'This link was not made in this browser, or it has expired.');
  const { server } = await connected();
  await server.takeBack(link).catch((thrown: { code?: string }) => {
    if (thrown.code !== 'NotThere') throw thrown; // it is gone already
  });
  keepLinks(links.filter((one) => one !== link));
}

/** The model file under a stored link. */
export async function readStored(link: { id: string; key: string }): Promise<Uint8Array> {
  const { server } = await connected();
  return server.storedModel(link);
}

const dateOf = (time: number) => new Date(time).toLocaleDateString(language().id, { dateStyle: 'medium' });

/** The part of the share dialog about short links; null where the host has no server. `modelFile` gives the model as it is. */
export async function storedSection(
  modelFile: () => Promise<{ name: string; bytes: Uint8Array }>,
): Promise<HTMLElement | null> {
  if (!(await hostInfo()).server) return null;
  const list = make('ul', { class: 'stored-links' });
  const days = make('select', { id: 'stored-days' });
  for (const count of [...kDays].sort((a, b) => a - b))
    days.append(make('option', { value: String(count) }, count === 1 ? t('1 day') : t('{n} days', { n: count })));
  days.value = String(kDays[0]);
  const store = iconButton('link', 'Make a short link', () => void makeLink(), '');
  const makeLink = async () => {
    store.disabled = true;
    try {
      const { name, bytes } = await modelFile();
      await storeModel(name, bytes, Number(days.value));
      draw();
    } catch (thrown) {
      toast(sentenceOf(thrown), 'error');
    } finally {
      store.disabled = false;
    }
  };
  const itemOf = (link: MadeLink) => {
    const field = make('input', { type: 'text', readonly: '', value: link.url, 'aria-label': 'Short link' });
    const back = iconButton('trash-2', 'Take it back', () => {
      back.disabled = true;
      takeBack(link.id).then(
        () => {
          draw();
          toast(t('The link to {name} is taken back: nobody can open it any more.', { name: link.name }));
        },
        (thrown: unknown) => {
          back.disabled = false;
          toast(sentenceOf(thrown), 'error');
        },
      );
    });
    const copy = iconButton('copy', 'Copy link', () => void copyField(field, 'The link is copied.'));
    return make(
      'li',
      {},
      make('p', {}, asIs(link.name), ' · ', t('until {date}', { date: dateOf(link.until) })),
      field,
      make('div', { class: 'dialog-buttons' }, back, copy),
    );
  };
  const draw = () => {
    const links = madeLinks().reverse();
    list.replaceChildren(...links.map(itemOf));
    const [last] = links;
    if (last) list.firstElementChild!.append(qrCode(last.url).svg);
  };
  draw();
  return make(
    'section',
    { class: 'stored', 'aria-label': 'Short link' },
    make('h3', {}, 'Short link, with the photos'),
    make('p', {}, 'The model is encrypted here and kept on this server. Only who has the link can open it.'),
    make('label', { for: 'stored-days' }, 'Keep it for'),
    make('div', { class: 'stored-make' }, days, store),
    list,
  );
}
