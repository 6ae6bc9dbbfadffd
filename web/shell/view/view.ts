// The viewer: shows one model, of a share text or of a GLB, and changes nothing on the visitor's device.
import './view.css';
import { adoptWords, byId, setAttribute, translatePage } from '../dom.ts';
import { Failure, isFailure, sentenceOf } from '../failure.ts';
import { ownAddress, wantedOf } from '../links.ts';
import { readServerLink, serverLink } from '../room/address.ts';
import type { ServerLink } from '../room/address.ts';
import { connected } from '../room/host.ts';
import { nameText } from '../words/names.ts';
import { language, onLanguage, preferredLanguage, speak, t } from '../words/words.ts';
import { wishOf } from './messages.ts';
import type { News } from './messages.ts';
import { Stage } from './stage.ts';

const isEmbedded = window.parent !== window;
const likesCalm = matchMedia('(prefers-reduced-motion: reduce)').matches;
const canvas = byId<HTMLCanvasElement>('canvas');
const spinButton = byId('spin');

const moduleAt = <T>(path: string): Promise<T> => import(new URL(path, document.baseURI).href) as Promise<T>;

function tell(news: News): void {
  if (isEmbedded) window.parent.postMessage(news, '*'); // the page around it knows the address anyway
}

/** Before a model is there, or in place of one: the poster stays. */
function say(state: 'poster' | 'loading' | 'failed', words: string): void {
  document.body.dataset.state = state;
  byId('words').textContent = t(words);
  byId('progress').hidden = state !== 'loading';
  byId('show').hidden = state !== 'poster';
  byId('home').hidden = state !== 'failed' || isEmbedded;
  byId('tools').hidden = true;
}

class Viewer {
  private stage: Stage | null = null;
  private glb: Uint8Array<ArrayBuffer> | null = null;
  /** What was asked for last is what is shown. */
  private asked = 0;

  /** The model of a share text. */
  showText(text: string): Promise<void> {
    return this.show('', ownAddress(text), async () => {
      const { derived } = await moduleAt<typeof import('./derive.ts')>(SPINELOFT_SITE.viewer.derive);
      return derived(text);
    });
  }

  /** A model that the server of this host keeps: as it was stored, with its photos. */
  showStored(link: ServerLink): Promise<void> {
    const own = serverLink(new URL('./', document.baseURI).href, { ...link, kind: 'own' });
    return this.show('', own, async () => {
      const { server } = await connected();
      return { glb: await server.storedModel(link), name: '' };
    });
  }

  /** A GLB that is there. */
  showGlb(glb: ArrayBuffer, name: string): Promise<void> {
    return this.show(name, null, async () => ({ glb: new Uint8Array(glb), name }));
  }

  /** A GLB beside the viewer: of its own host only. */
  showFile(path: string): Promise<void> {
    return this.show('', null, async () => {
      const address = new URL(path, document.baseURI);
      if (address.origin !== location.origin)
        throw new Failure('FileUnreadable', 'This viewer shows models of its own site only. Put the file beside it.');
      const response = await fetch(address).catch(() => null);
      if (!response?.ok)
        throw new Failure('FileUnreadable', 'The model did not load. Check its address and the connection.');
      return { glb: new Uint8Array(await response.arrayBuffer()), name: '' };
    });
  }

  look(yaw: number, pitch: number): void {
    this.stage?.spin(false);
    this.stage?.look(yaw, pitch);
  }

  home(): void {
    this.stage?.home();
  }

  turn(on = this.stage?.isTurning === false): void {
    this.stage?.spin(on);
  }

  /** Puts it where it can be seen as large as it is. */
  async placeInRoom(): Promise<void> {
    if (!this.glb) return;
    this.turn(false);
    const note = byId('note');
    note.textContent = t('Getting ready');
    try {
      const { showInRoom } = await moduleAt<typeof import('./room.ts')>(SPINELOFT_SITE.viewer.room);
      note.textContent = '';
      await showInRoom(this.glb, byId('name').textContent ?? '');
    } catch (thrown) {
      console.warn(thrown);
      note.textContent = t('This did not load. Check the connection and try again.');
    }
  }

  private async show(
    name: string,
    own: string | null,
    load: () => Promise<{ glb: Uint8Array; name: string }>,
  ): Promise<void> {
    const asked = ++this.asked;
    say('loading', 'Getting the model ready …');
    try {
      const model = await load();
      if (asked !== this.asked) return;
      const glb = new Uint8Array(model.glb);
      const { title, ...facts } = await this.onStage().show(glb.buffer);
      if (asked !== this.asked) return;
      this.glb = glb;
      const called = model.name || name || title;
      this.shown(called, own);
      tell({ type: 'spineloft:shown', name: called, ...facts });
    } catch (thrown) {
      if (asked !== this.asked) return;
      const sentence = sentenceOf(thrown);
      say('failed', sentence);
      // What has no solid yet can be gone on with.
      if (own !== null && isFailure(thrown) && thrown.code === 'NothingToExport') this.offer(own);
      tell({ type: 'spineloft:failed', code: isFailure(thrown) ? thrown.code : 'Unknown', sentence });
    }
  }

  private onStage(): Stage {
    try {
      this.stage ??= new Stage(canvas, (on) => setAttribute(spinButton, 'aria-pressed', String(on)));
    } catch {
      throw new Failure(
        'NoWebGL2',
        'This browser cannot draw in 3D: WebGL 2 is missing or switched off. Switch on graphics acceleration in its settings, or try another browser.',
      );
    }
    this.stage.isGuest = isEmbedded;
    return this.stage;
  }

  /** Lets the visitor have a copy; null: there is none. */
  private offer(own: string | null): void {
    byId('foot').hidden = own === null;
    if (own !== null) byId<HTMLAnchorElement>('mine').href = own;
  }

  private shown(name: string, own: string | null): void {
    document.body.dataset.state = 'shown';
    const called = nameText(name);
    byId('name').textContent = called;
    if (called) document.title = `${called} · SpineLoft`;
    byId('tools').hidden = false;
    this.offer(own);
    if (!likesCalm) this.stage?.spin(true);
    canvas.focus({ preventScroll: true, ...({ focusVisible: false } as FocusOptions) });
  }
}

/** Whether this device can show things in the room around it. */
async function hasRoom(): Promise<boolean> {
  const { xr } = navigator as Navigator & { xr?: { isSessionSupported(mode: string): Promise<boolean> } };
  if (document.createElement('a').relList.supports('ar')) return true; // Quick Look
  return (await xr?.isSessionSupported('immersive-ar').catch(() => false)) ?? false;
}

function connect(viewer: Viewer): void {
  spinButton.addEventListener('click', () => viewer.turn());
  byId('front').addEventListener('click', () => viewer.look(0, 0));
  byId('ar').addEventListener('click', () => void viewer.placeInRoom());
  void hasRoom().then((has) => {
    byId('ar').hidden = !has;
  });
  if (isEmbedded) {
    document.body.dataset.embedded = '';
    for (const id of ['mine', 'brand']) {
      setAttribute(byId(id), 'target', '_blank');
      setAttribute(byId(id), 'rel', 'noopener');
    }
  }
  window.addEventListener('message', ({ source, data }) => {
    const wish = isEmbedded && source === window.parent ? wishOf(data) : null;
    if (!wish) return;
    if (wish.type === 'spineloft:turn') viewer.turn(wish.on);
    else if (wish.type === 'spineloft:look') viewer.look((wish.yaw * Math.PI) / 180, (wish.pitch * Math.PI) / 180);
    else if ('text' in wish) void viewer.showText(wish.text);
    else void viewer.showGlb(wish.glb, wish.name ?? '');
  });
}

/** Shows what the address asks for; inside another page a text waits for a press, since the engine is large. */
function begin(viewer: Viewer): void {
  const { text, glb, poster } = wantedOf(location.hash);
  const stored = readServerLink(location.hash);
  const picture = byId<HTMLImageElement>('poster');
  if (poster) picture.src = poster;
  else picture.dataset.mark = '';
  if (stored?.kind === 'stored') void viewer.showStored(stored);
  else if (text !== null && isEmbedded) {
    say('poster', '');
    byId('show').onclick = () => void viewer.showText(text);
  } else if (text !== null) void viewer.showText(text);
  else if (glb !== null) void viewer.showFile(glb);
  else if (isEmbedded) say('loading', '');
  else say('failed', 'There is no model of SpineLoft in that link. Copy the whole link again and open it.');
}

async function main(): Promise<void> {
  adoptWords(document.body);
  onLanguage(translatePage);
  const { id } = preferredLanguage();
  if (id !== language().id) await speak(id).catch((thrown: unknown) => console.warn(thrown));
  const viewer = new Viewer();
  connect(viewer);
  begin(viewer);
  window.addEventListener('hashchange', () => begin(viewer));
  tell({ type: 'spineloft:ready' });
}

void main();
