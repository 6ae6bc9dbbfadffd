// window.spineloft: installed before the engine runs, so that a script can wait for `ready`.
import type { Command, ExportFormat, KeptModelInfo, SharedLink, SpineLoftApi, State } from './api.ts';
import type { Engine } from './engine.ts';
import { Failure } from './failure.ts';
import type { ModelInfo } from './keep/store.ts';
import { canvasUnit } from './text_size.ts';
import { pngOf } from './turntable.ts';

const kPollMs = 12;
/** A page that draws slower than this is not waited for. */
const kFramesMs = 1000;
const kFormats: ExportFormat[] = ['glb', 'obj', 'stl', 'spineloft', 'zip', '3mf', 'png'];

export interface ApiPage {
  /** Null until the engine runs. */
  engine(): Engine | null;
  canvas: HTMLCanvasElement;
  ready: Promise<void>;
  page: {
    /** Decodes and opens a picture; rejects with a Failure. */
    openImage(blob: Blob, name: string): Promise<void>;
    /** The same of a model file. */
    openProject(blob: Blob): Promise<void>;
    shareLink(options: { photos: boolean }): Promise<SharedLink>;
    storeLink(): Promise<SharedLink>;
    takeBackLink(text: string): Promise<void>;
    openLink(link: string): Promise<void>;
    listModels(): Promise<ModelInfo[]>;
    /** Throws while another tab has the model. */
    mustBeChangeable(): void;
    /** True while the shell itself has work, such as decoding a picture or keeping a step. */
    readonly isBusy: boolean;
  };
}

const kBeforeReady: State = {
  version: SPINELOFT_SITE.version,
  picture: null,
  pictures: 0,
  pictureList: [],
  pen: { size: 'medium', eraser: 'medium', colour: '#1f2430', points: null, menu: false },
  parts: [],
  steps: [],
  hollow: null,
  picked: [],
  selectedStep: null,
  selected: [],
  groups: [],
  snap: false,
  gizmo: null,
  modes: ['model'],
  hover: { part: null, end: null, other: -1, handle: -1, bone: false, depth: -1, mark: -1 },
  chosen: { end: null, handle: -1, boneHandle: -1, shapeHandle: -1, bridge: -1, pull: -1, outline: null },
  touched: [],
  options: {
    ribReach: 0.06,
    boneReach: 0.25,
    bothSides: false,
    keepRibs: false,
    wholePicture: false,
    paintOver: false,
    depthByPressure: false,
    brush: 14,
    hiddenPen: false,
    pullReach: 0.12,
    pullSharp: false,
    bridgeWidth: 1,
  },
  selection: null,
  tool: 'draw',
  axis: null,
  sheet: null,
  boneHandles: [],
  nextShape: 'ball',
  shapeOutline: [],
  shapeHandles: [],
  drawings: [],
  bridges: [],
  lineEnds: [],
  depthDots: [],
  pullKnobs: [],
  bridgeKnobs: [],
  undo: 0,
  redo: 0,
  history: { bytes: 0, budget: 0 },
  busy: true,
  threads: 0,
  lastMs: { edges: 0, ribs: 0, loft: 0 },
  unsaved: false,
  activity: null,
  preview: null,
  documentName: '',
  heightMm: 0,
  beside: null,
  cutByBox: false,
  cutByScribble: false,
  cut: null,
  print: null,
  shelf: [],
  controls: [],
  slice: 0,
  placing: false,
  sliceBoard: null,
};

function wait(milliseconds: number): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, milliseconds));
}

/** When two frames were drawn: the bars of the first may take room from the picture in the second. */
function drawn(): Promise<void> {
  if (document.hidden) return Promise.resolve(); // nothing is drawn there
  const frames = new Promise<void>((resolve) => {
    requestAnimationFrame(() => requestAnimationFrame(() => resolve()));
  });
  return Promise.race([frames, wait(kFramesMs)]);
}

function keptModelOf({
  id,
  name,
  created,
  modified,
  pictures,
  parts,
  baseSize,
  journalSize,
}: ModelInfo): KeptModelInfo {
  return { id, name, created, modified, pictures, parts, bytes: baseSize + journalSize };
}

/** Puts the API on the window. */
export function installApi(api: ApiPage): void {
  const { page } = api;
  const running = async (): Promise<Engine> => {
    await api.ready;
    const engine = api.engine();
    if (!engine) throw new Failure('NotReady', 'The page is not ready yet. Wait for spineloft.ready.');
    return engine;
  };
  const installed: SpineLoftApi = {
    version: SPINELOFT_SITE.version,
    ready: api.ready,
    async idle() {
      const engine = await running();
      // Twice in a row: finished work may start the next stage.
      for (let quiet = 0; quiet < 2;) {
        quiet = engine.isIdle() && !page.isBusy ? quiet + 1 : 0;
        await wait(kPollMs);
      }
    },
    async openImage(blob, name = 'Picture') {
      await running();
      await page.openImage(blob, name);
    },
    async openProject(blob) {
      await running();
      await page.openProject(blob);
    },
    async shareLink({ stored = false, photos = false } = {}) {
      await running();
      // What is still searched for is found first: the ribs in a photo are fixed as they are.
      await installed.idle();
      return stored ? page.storeLink() : page.shareLink({ photos });
    },
    async takeBackLink(text) {
      await page.takeBackLink(text);
    },
    async openShareText(text) {
      await running();
      await page.openLink(text);
    },
    async models() {
      await running();
      return (await page.listModels()).map(keptModelOf);
    },
    imageToClient(x, y) {
      const box = api.canvas.getBoundingClientRect();
      const at = api.engine()?.imageToCanvas(x, y) ?? { x: 0, y: 0 };
      const unit = canvasUnit();
      return { x: at.x * unit + box.left, y: at.y * unit + box.top };
    },
    memory: () => api.engine()?.memory() ?? { engine: 0, solver: 0, cutter: 0 },
    history: () => api.engine()?.history() ?? '',
    state: () => api.engine()?.state() ?? structuredClone(kBeforeReady),
    commands: (): Command[] => api.engine()?.commands() ?? [],
    async run(id, args) {
      const engine = await running();
      page.mustBeChangeable();
      engine.run(id, args);
      await drawn();
    },
    async exportModel(format) {
      const engine = await running();
      if (!kFormats.includes(format)) {
        throw new Failure(
          'ValueOutOfRange',
          `There is no export to "${String(format)}". Choose glb, obj, zip, stl, 3mf, png or spineloft.`,
        );
      }
      // A file holds finished solids, and parts that do not go through themselves.
      await installed.idle();
      if (format !== 'spineloft') engine.finishParts();
      await installed.idle();
      if (format !== 'png') return engine.exportModel(format);
      const png = await pngOf(engine);
      if (!png) throw new Failure('NothingToExport', engine.sentence('NothingToExport'));
      return png;
    },
  };
  Object.defineProperty(window, 'spineloft', { value: Object.freeze(installed), enumerable: true });
}
