// The page starts here: look whether this browser can run it, load the engine, connect everything.
import './styles/base.css';
import './styles/chrome.css';
import './styles/class.css';
import './styles/models.css';
import './styles/popups.css';
import './styles/start.css';
import './styles/forced.css'; // last: it is over the others
import { adoptWords, asIs, byId, make, translatePage } from './dom.ts';
import type { Engine } from './engine.ts';
import type { Failure } from './failure.ts';
import { connectFiles } from './files.ts';
import { openLanguages } from './help.ts';
import { icon } from './icons.ts';
import { watchInputKind } from './input_kind.ts';
import { connectKeyboard } from './keyboard.ts';
import { KeyboardPen } from './keyboard_pen.ts';
import { receiveFiles, startOffline } from './offline/offline.ts';
import { kLinkMark, takeOwn, viewerFor } from './links.ts';
import { Page } from './page.ts';
import { connectPointer } from './pointer.ts';
import { installApi } from './public_api.ts';
import { startEngine } from './start_engine.ts';
import { buildStartPage, kSamples, sampleAddress } from './start_page.ts';
import { sizeOf, watchContext, watchPalette, watchSize } from './surface.ts';
import { toast } from './toasts.ts';
import { serverLink, takeServerLink } from './room/address.ts';
import { Classroom } from './room/classroom.ts';
import { connectTooltips } from './tooltip.ts';
import { fetchRest, warmUpWhenIdle } from './warm_up.ts';
import { language, onLanguage, preferredLanguage, speak, t } from './words/words.ts';

const canvas = byId<HTMLCanvasElement>('canvas');

/** The page cannot run: say why in the place of the drop area. */
function showFailure(failure: Failure): void {
  const again = make('button', { type: 'button', class: 'button button-primary button-large' }, 'Load again');
  again.addEventListener('click', () => location.reload());
  byId('start').replaceChildren(
    make(
      'div',
      { class: 'start-failure', role: 'alert' },
      make('h2', {}, 'SpineLoft cannot start here'),
      make('p', {}, failure.message),
      again,
    ),
  );
}

function connect(page: Page, engine: Engine): void {
  watchSize(canvas, (size) => engine.resize(size));
  watchPalette((palette) => engine.setPalette(palette));
  watchContext({ canvas, engine, say: (text) => page.say(text) });
  connectPointer({ canvas, engine, undo: () => page.run('undo'), redo: () => page.run('redo') });
  const pen = new KeyboardPen({ canvas, engine, say: (text) => page.say(text) });
  watchInputKind(document.documentElement);
  connectKeyboard({
    engine,
    pen,
    show: (dialog) => page.show(dialog),
    isQuiet: () => page.isOnStartPage,
    isLocked: () => page.isReadOnly || !byId('wall').hidden,
  });
  window.addEventListener('beforeunload', (event) => {
    if (page.hasUnsavedWork) event.preventDefault();
  });
}

/** The button of the start page: its language by name, and the others behind it. */
function connectLanguage(page: Page): void {
  const button = byId('language');
  const show = () => {
    button.replaceChildren(icon('languages'), make('span', {}, asIs(language().name)));
    button.setAttribute('aria-label', `${t('Language')}: ${language().name}`);
  };
  button.addEventListener('click', () => openLanguages(button, (id) => void page.speak(id)));
  onLanguage(() => {
    show();
    translatePage();
  });
  show();
}

/** Without its words the page stays in English. */
async function speakPreferred(): Promise<void> {
  adoptWords(document.body);
  const { id } = preferredLanguage();
  if (id === 'en') return;
  await speak(id).catch((thrown: unknown) => console.warn(thrown));
}

function main(): void {
  const speaking = speakPreferred();
  const page = new Page();
  connectLanguage(page);
  let engine: Engine | null = null;
  const starting = startEngine(
    canvas,
    (event) => page.handle(event),
    () => sizeOf(canvas),
  );
  const ready = starting.then(async (started) => {
    connect(page, started);
    await speaking;
    await page.attach(started);
    engine = started;
    document.body.dataset.engine = 'ready';
    fetchRest(started);
    warmUpWhenIdle(started);
  });
  installApi({ engine: () => engine, canvas, ready, page });
  ready.catch((failure: Failure) => showFailure(failure));

  // What is chosen before the engine runs is opened as soon as it does; the last choice counts.
  let pending: (() => void) | null = null;
  const whenReady = (action: () => void) => {
    if (engine) {
      action();
      return;
    }
    pending = action;
    page.showLoading(() => {
      pending = null;
    });
  };
  ready.then(
    () => pending?.(),
    () => page.showLoading(null),
  );
  const open = (files: File[]) => whenReady(() => void page.openFiles(files));
  receiveFiles(open);
  ready.then(
    () => startOffline({ hasUnsavedWork: () => page.hasUnsavedWork }),
    () => undefined,
  );
  connectFiles(open, () =>
    toast('That was not a file. Drop a PNG or JPEG picture or a model from your device.', 'error'),
  );
  buildStartPage(
    (sample) => {
      whenReady(() => void page.openSample(sample, sampleAddress(sample), sample === kSamples[0]));
    },
    () => whenReady(() => void page.drawOnPaper()),
    () => whenReady(() => page.show('help')),
  );
  connectTooltips(byId('bar'));
  const classroom = new Classroom({
    engine: () => engine,
    openModel: async (bytes) => {
      await page.openProject(new Blob([bytes as BlobPart]));
      await window.spineloft.idle();
      return page.currentModel;
    },
    currentModel: () => page.currentModel,
    isOnStartPage: () => page.isOnStartPage,
    back: () => page.refresh(),
  });
  page.onNextPupil = () => classroom.leave();
  ready.then(
    () => classroom.begin(),
    () => undefined,
  );
  const openAddress = () => {
    const onServer = takeServerLink();
    if (onServer?.kind === 'stored') {
      location.assign(serverLink(new URL('view.html', document.baseURI).href, onServer)); // a model is looked at first
    } else if (onServer?.kind === 'own') {
      const address = serverLink('', onServer);
      whenReady(() => void page.openLink(address).catch((thrown: unknown) => page.complain(thrown)));
    } else if (onServer) {
      ready.then(
        () => classroom.follow(onServer),
        () => undefined,
      );
    }
    const viewer = viewerFor(location);
    if (viewer) location.assign(viewer);
    const text = takeOwn();
    if (text) whenReady(() => void page.openLink(kLinkMark + text).catch((thrown: unknown) => page.complain(thrown)));
  };
  window.addEventListener('hashchange', openAddress);
  openAddress();
}

// A model in a link is looked at first.
const viewer = viewerFor(location);
if (viewer) location.replace(viewer);
else main();
