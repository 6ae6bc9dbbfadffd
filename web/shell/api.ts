// The public API of the page, `window.spineloft`: plain JSON in and out, for tests, embedders and
// scripts. This file is its contract; assets/docs/api.md is made from it (node .ci/api_page.mjs).

/** A point in picture pixels: x to the right, y down, pixel centres at integers. */
export type PicturePoint = [x: number, y: number];

/** How sure a rib end is: on an edge, bridged between edges, guessed from its neighbours, put there by hand, or held there. */
export type RibState = 'edge' | 'bridged' | 'guessed' | 'edited' | 'locked';

/** One end of one rib of the selected part. */
export interface RibEnd {
  rib: number;
  side: 'left' | 'right';
}

/** Where a part stands instead of where it was drawn. */
export interface Pose {
  /** The line of its bone; empty: as drawn. */
  stroke: PicturePoint[];
  /** [place 0…1, picture pixels towards the viewer]. */
  depth: [at: number, depth: number][];
  /** Turns of a coil and how far it is from its line, picture pixels. */
  turns: number;
  radius: number;
  /** Its ends are joined. */
  closed: boolean;
}

export interface Rib {
  center: PicturePoint;
  left: PicturePoint;
  right: PicturePoint;
  leftState: RibState;
  rightState: RibState;
  /** Other places where the end might stand, best first. */
  leftOthers: PicturePoint[];
  rightOthers: PicturePoint[];
}

/** One of the slices along a bone. */
export interface SectionKey {
  /** Share of the bone's length, 0…1. */
  at: number;
  /** Key of the preset, or 'drawn'. */
  section: string;
  /** Outer curves and holes. */
  curves: number;
  holes: number;
  /** How it becomes the next one: 'linear', 'ease', 'square', 'root', 'overshoot', 'flow', 'hold' or 'custom'. */
  blend: string;
}

/** Points [place 0…1, value] of the curves along a bone; empty: none. */
export interface AlongCurves {
  /** Turns. */
  twist: [number, number][];
  /** Depth for the width, 1 = as chosen. */
  squash: [number, number][];
  /** Degrees. */
  tilt: [number, number][];
  /** −1 flat front … 1 flat back. */
  bulge: [number, number][];
}

/** Where a part stands: p ↦ pivot + move + turn(scale · (p − pivot)), x mirrored first when `mirrored`. A picture's longer side is 1. */
export interface Placement {
  pivot: [number, number, number];
  move: [number, number, number];
  /** Unit quaternion, w first. */
  turn: [number, number, number, number];
  scale: number;
  mirrored: boolean;
  /** `move` in millimetres: right, up, to the front. */
  mm: [number, number, number];
  /** `turn` in degrees: tipped over, turned round, leaning. */
  degrees: [number, number, number];
}

/** What of a picture becomes heights: dark strokes, brightness, or light and shadow. */
export type ReliefMode = 'ink' | 'bright' | 'shade';

/** Where a bridge stands on a part. */
export interface BridgeEnd {
  part: number;
  /** The middle of its rim as [x, y, z] and how far that is from it, picture pixels of the bridge; null: it has no shape. */
  at: [number, number, number] | null;
  radius: number | null;
}

/** A ball, a box or another shape; pixels of its picture, outlines of theirs. */
export interface ShapeInfo {
  /** 'ball', 'egg', 'box', 'cylinder', 'capsule', 'cone', 'pyramid' or 'half-ball'. */
  kind: string;
  axis: PicturePoint[];
  width: number;
  /** 'round': everywhere `ratio` times as deep as wide; 'kept': as deep as it was before an outline was drawn. */
  depth: 'round' | 'kept';
  ratio: number;
  outlines: { picture: number; lines: PicturePoint[][] }[];
}

/** A line drawing: its lines and pieces, and what follows from them. Picture pixels; places along lines are shares of their length. */
export interface LineDrawing {
  id: number;
  picture: number;
  /** From where its right angles are seen; 'unknown': they say nothing. */
  seenFrom: 'above' | 'below' | 'unknown';
  /** `waits`: no piece has a stretch of it. */
  lines: {
    id: number;
    points: PicturePoint[];
    hidden: [from: number, to: number][];
    closed: boolean;
    waits: boolean;
  }[];
  pieces: {
    part: number;
    kind: 'round' | 'flat' | 'solid';
    outlines: { line: number; from: number; to: number }[][];
  }[];
  /** Depths that are given: larger is nearer to the viewer. */
  pins: { line: number; at: number; z: number }[];
  /** Parts that overlap at a place: who is in front there, and whether a line says so, it follows, it is a guess, or it was told. */
  orders: {
    over: number;
    under: number;
    at: PicturePoint;
    kind: 'over' | 'inside';
    from: 'drawn' | 'deduced' | 'guessed' | 'user';
  }[];
  /** Parts whose lines cannot all be as they are drawn; without a place it is their depths that cannot. */
  contradictions: { pieces: number[]; at: PicturePoint | null }[];
  /** Where lines that wait end at nothing. */
  openEnds: { line: number; at: PicturePoint }[];
}

/** The bones found in the outline of a puff with a slice, as changed by hand; picture pixels. */
export interface PuffBones {
  ends: number;
  forks: number;
  /** Bones that close round a hole. */
  rings: number;
  length: number;
  /** Changes by hand that find no place in this outline; they are kept. */
  asleep: number;
  /** Rings that are too thin to show, and drawn thicker. */
  thickened: number;
  branches: PicturePoint[][];
  /** Bones that are left out. */
  gone: PicturePoint[][];
  /** Places with a knob, and how many times as thick the puff is there. */
  knobs: [x: number, y: number, factor: number][];
  /** Its slices; the one without a place is wherever no other is near. */
  slices: { slice: string; at: PicturePoint | null }[];
}

export interface Part {
  id: number;
  name: string;
  /** How the part was made: 'loft' = one stroke with ribs, 'puff' = a region that swells, 'sheet' = a flat piece, 'lathe' = a line turned about an axis, 'stack' = closed lines above each other, 'shape' = a ball, a box or another shape, 'element' = a piece of a line drawing. */
  kind: 'loft' | 'puff' | 'sheet' | 'lathe' | 'stack' | 'shape' | 'element';
  /** Key of the slice, such as 'circle' or 'rounded-square'. */
  section: string;
  /** All slices along the bone, in order. */
  slices: SectionKey[];
  along: AlongCurves;
  /** Keys of the two ends: 'flat', 'round', 'pointed' or 'open'. */
  caps: { start: string; end: string };
  ribs: Rib[];
  /** How many ends were put somewhere, ribs added and left out by hand. */
  edits: { ends: number; added: number; removed: number };
  /** Scribbles over edges that do not count for this part. */
  ignored: number;
  /** So many of them paint over: what is under them is not on the part. */
  paintedOver: number;
  pose: Pose;
  /** The handles of its bone, from start to end. */
  bone: PicturePoint[];
  /** Of a puff with a slice. */
  bones: PuffBones | null;
  /** Of a shape. */
  shape: ShapeInfo | null;
  /** Of a loft or a puff whose depth an outline in a side picture says; pixels of that picture. */
  side: { picture: number; lines: PicturePoint[][] } | null;
  /** Lines on its surface that are moved, in order: how many points each has, how many it goes to and how many its ring has (0: no bump), height and radius in picture pixels, and the share of the way that it could go without going through itself. */
  pulls: { points: number; height: number; to: number; radius: number; crease: boolean; ring: number; share: number }[];
  /** Of a bridge: the parts that it joins, and its rims on them. */
  bridge: { from: BridgeEnd; to: BridgeEnd } | null;
  /** Detail that a picture gives to its front; null: none. `region`: how many lines bound it (0: all that is seen); `made` is null until it is known: `mode` is 'ink' where light and shadow were asked for and explain less than a fifth of the brightness, `seen` false where too little of the part is seen, `raises` false where the picture shows nothing that could become a relief, `share` that of the height that it could have without going through itself. */
  relief: {
    mode: ReliefMode;
    height: number;
    smooth: number;
    region: number;
    laid: { picture: number; at: PicturePoint; width: number; turn: number } | null;
    made: { mode: ReliefMode; seen: boolean; raises: boolean; explained: number; share: number } | null;
  } | null;
  triangles: number;
  visible: boolean;
  /** True with the picture on it, else it has the plain colour '#rrggbb'. */
  textured: boolean;
  colour: string;
  /** Without the picture: 'plain', 'two-tone', 'clay', 'glaze' or 'metal'; the colour below of 'two-tone'. */
  paint: string;
  second: string;
  /** True when every triangle is flat. */
  faceted: boolean;
  /** True when the ink of its outline on paper stays on it. */
  inked: boolean;
  /** Id of the picture that it was drawn on. */
  picture: number;
  placement: Placement;
  /** Plane of live symmetry: a point and a unit normal; null: it shows once. */
  mirror: [number, number, number, number, number, number] | null;
  /** Id of its group. */
  group: number | null;
  /** On the screen with what its stroke found by itself, or not yet; it settles in a moment (`idle`). */
  waiting: boolean;
  /** Name of the error that left it without a shape. */
  failure: string | null;
  /** It goes through itself, and the files since the last save or check hold it without that. */
  mended: boolean;
  /** Where it goes through itself, world, if the last save or check found that it does and it could not be mended. */
  crossesAt: [number, number, number] | null;
}

export interface PictureInfo {
  id: number;
  name: string;
  width: number;
  height: number;
  /** True for paper that is drawn on with the pen. */
  sketch: boolean;
}

export interface ListedPicture extends PictureInfo {
  /** What it shows of another picture: from where it looks, and how its pixels lie in the space of that one (method-shapes.md). */
  view: { of: number; from: 'right' | 'left' | 'back' | 'top'; middle: number; scale: number; shift: number } | null;
}

export interface ShownPicture extends PictureInfo {
  /** Strokes of the pen and the eraser on it. */
  strokes: number;
  /** True once something is drawn that a bone could go through. */
  finished: boolean;
  /** Scribbles over edges that count for none of its parts. */
  ignored: number;
  /** So many of them paint over: what is under them is not on the part. */
  paintedOver: number;
}

export type PenSize = 'fine' | 'medium' | 'bold';

/** What a solid is made of. */
export type Operand = { part: number } | { step: number };

/** A solid made of parts and other solids. */
export interface Step {
  id: number;
  name: string;
  kind: 'join' | 'cut' | 'common' | 'hollow';
  operands: Operand[];
  /** Radius at its seams and thickness of its wall; 1 is the longer side of a picture. */
  blend: number;
  wall: number;
  /** 'none', 'start', 'end', 'up', 'down', 'left', 'right', 'front' or 'back', and the share cut off there. */
  opening: string;
  openingDepth: number;
  visible: boolean;
  /** It stands alone; else it is inside another solid. */
  root: boolean;
  /** One look everywhere, instead of those of its parts. */
  ownLook: boolean;
  textured: boolean;
  colour: string;
  /** 'inside': only the outermost solid is made and shown. */
  status: 'ready' | 'waiting' | 'failed' | 'inside';
  /** Why there is none, as an error's name and as a sentence, the part at fault and where it shows (world). */
  failure: string | null;
  sentence: string;
  faulty: number | null;
  at: [number, number, number] | null;
  /** Of the last good solid: volume and area in units of the world. */
  triangles: number;
  volume: number;
  area: number;
  genus: number;
  /** What the solver took. */
  ms: number;
}

/** Something on the canvas that can be pressed; 'words' are told and cannot be. Names of parts are the words of rows and grips. */
export interface Control {
  kind: 'button' | 'row' | 'grip' | 'field' | 'slider' | 'section' | 'tab' | 'words' | 'rib';
  words: string;
  /** CSS pixels of the canvas at the usual size of text (1rem is 16 of them). */
  at: [x: number, y: number, width: number, height: number];
  /** False: its panel has to be scrolled first, or it is for screen readers alone, as the points of graphs are. */
  inSight: boolean;
  enabled: boolean;
  on: boolean;
  /** Its number for as long as it is shown; 0 for words. */
  id: number;
  /** The command that it runs. */
  command: string | null;
  /** Of a slider: its ends and its value in the unit that it shows, and the value in words. */
  slide: { low: number; high: number; value: number; text: string } | null;
}

/** What is on the page now. A copy: changing it changes nothing. */
export interface State {
  version: string;
  /** The picture in view, in original pixels; null on the start page. */
  picture: ShownPicture | null;
  /** Number of pictures on the board. */
  pictures: number;
  /** All of them, in the order of the picture strip. */
  pictureList: ListedPicture[];
  /** What pen and eraser are set to, how many points the stroke in hand has, and whether a menu of theirs is open. */
  pen: { size: PenSize; eraser: PenSize; colour: string; points: number | null; menu: boolean };
  parts: Part[];
  /** Ids of all parts in hand: the selected ones with the rest of their groups. */
  selected: number[];
  groups: { id: number; name: string }[];
  /** A dragged part settles on the surface under the pointer. */
  snap: boolean;
  /** The handles for placing, CSS pixels of the canvas: 'x', 'y', 'z', 'turn-x', 'turn-y', 'turn-z', 'plane', 'depth', 'scale'. */
  gizmo: { at: [number, number]; held: boolean; knobs: { handle: string; at: [number, number] }[] } | null;
  /** Solids made of parts. */
  steps: Step[];
  /** What *Scoop out* shows before it does it: what becomes hollow, with its wall and opening. */
  hollow: { what: Operand[]; wall: number; opening: string; openingDepth: number } | null;
  /** Ticked in the list for the next solid, in this order. */
  picked: Operand[];
  /** Id of the chosen solid. */
  selectedStep: number | null;
  /** Id of the selected part. */
  selection: number | null;
  /** 'draw', 'hand' for moving the picture, 'ribs', 'shape', 'bone', 'ignore', 'pen' and 'eraser' on paper, 'move', 'puff', 'sheet', 'spin', 'layers', 'shapes', 'lines', 'pull', 'bridge' */
  tool: string;
  /** The ends of the dashed line of the tool 'spin', picture pixels. */
  axis: PicturePoint[] | null;
  /** The sheet of the tool 'layers': its place (a share of the rail; without a rail the number of a layer), half its side in picture pixels, the layer that it lies on and whether that is off the rail, the layers of its part, and where its corners ([-half, -half] first) and its knob are on the canvas, CSS pixels. */
  sheet: {
    at: number;
    half: number;
    layer: number | null;
    free: boolean;
    layers: { at: number; curves: number }[];
    corners: ([number, number] | null)[];
    knob: [number, number] | null;
    /**
     * Which curves of a layer and the next become each other, or might, beside the sheet, where a layer has several: `of`: layer, curve, curve of the next; a tap on its mark changes it.
     */
    links: { of: [number, number, number]; on: boolean; mark: [number, number] | null }[];
    /** Degrees by which its edges to the viewer and to the right are ahead along the rail, and the knobs that lean it; `drawsRail`: the next line in the solid view becomes the rail. */
    lean: { front: number; side: number };
    leanKnobs: ([number, number] | null)[];
    drawsRail: boolean;
    /** Where a curve of a layer (`of`: layer, curve) parts into several of the next (`up`) or several of the one before join into it: `at`, 0…1 of the way to them. */
    forks: { of: [number, number]; up: boolean; at: number; knob: [number, number] | null }[];
  } | null;
  /** What the tool 'bone' can take hold of on a puff with a slice, in CSS pixels of the canvas: ends and forks, knobs for its thickness, places of slices, bones, and those left out. */
  boneHandles: { hold: 'node' | 'knob' | 'slice' | 'bone' | 'gone'; at: [number, number] }[];
  /** What the tool 'shapes' draws next: a key as of ShapeInfo.kind. */
  nextShape: string;
  /** The outline of the shape that it has in hand, pixels of the picture in view; empty: none is in hand. */
  shapeOutline: PicturePoint[];
  /** What it can take hold of there, in CSS pixels of the canvas: both ends of the axis, the middle, the width; in a side picture the depth. */
  shapeHandles: { hold: 'from' | 'to' | 'middle' | 'width' | 'depth'; at: [number, number] }[];
  /** Line drawings. */
  drawings: LineDrawing[];
  /** Where the tool 'lines' swaps two parts that overlap in the picture in view, in CSS pixels of the canvas. */
  bridges: { over: number; under: number; guessed: boolean; at: [number, number] }[];
  /** Where it closes a line, the same. */
  lineEnds: [number, number][];
  /** What it can drag nearer or farther of the selected piece in the solid view, the same: places `along` a line, 0 to 1, at the depth `z` in picture pixels, `pinned` where it is given. */
  depthDots: { line: number; along: number; z: number; pinned: boolean; at: [number, number] }[];
  /** Knobs of the pulls of the part in hand of the tool 'pull', CSS pixels of the canvas (null: behind the eye); a drag takes those that face the eye, and the chosen one. */
  pullKnobs: { pull: number; facing: boolean; at: [number, number] | null }[];
  /** Ends of the bridge in hand of the tool 'bridge', CSS pixels of the canvas (null: behind the eye); a drag moves them. */
  bridgeKnobs: ([number, number] | null)[];
  /** What is open above the model, the topmost first: Escape ends the first that can end; the last is 'model'. */
  modes: string[];
  /** Steps that undo and redo could go. */
  undo: number;
  redo: number;
  /** Bytes that the steps of undo and redo take, and how many they may. */
  history: { bytes: number; budget: number };
  /** True while work is pending; `idle()` waits for its end. */
  busy: boolean;
  /** Worker threads of the engine; 0 in the single-thread build. */
  threads: number;
  /** Milliseconds of the last run of each stage. */
  lastMs: { edges: number; ribs: number; loft: number };
  /** True when something was drawn (parts, strokes on paper, scribbles over edges) and no GLB or .spineloft file holds the model as it is; the page keeps it on the device all the same. */
  unsaved: boolean;
  /** Long work in words, with its share done (0…1). */
  activity: { label: string; done: number } | null;
  /** What the gesture in hand would make, and of which part (null: a new one); fresh when its shape is up to date. */
  preview: {
    points: number;
    part: number | null;
    fresh: boolean;
    ribs: number;
    triangles: number;
    costMs: number;
  } | null;
  /** What lies under the pointer; −1: none. `mark` is a scribble. */
  hover: {
    part: number | null;
    end: RibEnd | null;
    other: number;
    handle: number;
    bone: boolean;
    depth: number;
    mark: number;
  };
  /** What the arrow keys move. */
  chosen: {
    end: RibEnd | null;
    handle: number;
    boneHandle: number;
    shapeHandle: number;
    bridge: number;
    pull: number;
    outline: [number, number] | null;
  };
  /** Rib ends that the line in hand moves. */
  touched: RibEnd[];
  /** How the tools work; reaches are shares of the bone's length, the brush is in CSS pixels. */
  options: {
    ribReach: number;
    boneReach: number;
    bothSides: boolean;
    keepRibs: boolean;
    wholePicture: boolean;
    paintOver: boolean;
    depthByPressure: boolean;
    brush: number;
    /** Lines of the tool 'lines' have something in front of them. */
    hiddenPen: boolean;
    /** Of the next pull: its radius, a share of the part's diagonal, and whether it makes an edge along its line. */
    pullReach: number;
    pullSharp: boolean;
    /** Of the next bridge: how wide it is, times as usual. */
    bridgeWidth: number;
  };
  /** The visitor's own slices. */
  shelf: { id: number; name: string }[];
  /** Index of the slice that is changed next, of several along the bone. */
  slice: number;
  /** True while a tap on the bone puts a slice there. */
  placing: boolean;
  /** The open drawing board for a slice; its square [−1.18, 1.18]² lies at [x, y, side] of the canvas. */
  sliceBoard: {
    tool: string;
    symmetry: { leftRight: boolean; frontBack: boolean; fold: number };
    curves: [x: number, y: number, corner: boolean][][];
    problem: string | null;
    undo: number;
    redo: number;
    square: [x: number, y: number, side: number];
  } | null;
  documentName: string;
  heightMm: number;
  /** What the panels on the canvas show, as of the last frame. */
  controls: Control[];
  /** A drag of "Puff" and "Flat piece" is a box round the thing. */
  cutByBox: boolean;
  /** A drag of theirs is a scribble over the thing. */
  cutByScribble: boolean;
  /** What is being cut out of the picture: its outlines so far, and how many marks correct it. */
  cut: { searching: boolean; adding: boolean; marks: number; undone: number; contours: [number, number][][] } | null;
  /** What stands beside the solid, as large as it is: coin, cupcake, hand. */
  beside: string | null;
  /** The last check for printing, null when the model has changed since. Lengths in millimetres, `lean` in radians. */
  print: {
    closed: boolean;
    /** How many come off the printer: what touches is one. */
    pieces: number;
    size: number[];
    thinnest: number;
    lean: number;
    stands: boolean;
    volume: number;
    printer: string | null;
    lines: { good: boolean; text: string; fix: string }[];
  } | null;
}

export interface CommandChoice {
  value: string | number;
  label: string;
  /** The name of its picture in the menu. */
  icon?: string;
  toggled?: boolean;
}

/** One row of the command table. */
export interface Command {
  id: string;
  label: string;
  /** Name of a Lucide icon. */
  icon: string;
  /** Keys, such as "Ctrl+Z"; empty when there are none. */
  shortcut: string;
  enabled: boolean;
  group: string;
  /** For switches: on or off; null or absent for plain commands. */
  toggled?: boolean | null;
  /** One sentence about what it does. */
  hint?: string;
  /** The heading under which the menu "More" offers it while it can be run; null: the search finds it. */
  menu?: string | null;
  /** What `run` wants besides the id. */
  argument?: {
    key: string;
    kind?: 'text' | 'number' | 'api';
    choices?: CommandChoice[];
  } | null;
}

/** 'zip': OBJ with its colours and its picture. 'png': a picture of the solid with the whole model inside. */
export type ExportFormat = 'glb' | 'obj' | 'stl' | 'spineloft' | 'zip' | '3mf' | 'png';

/** A model that this device keeps. */
export interface KeptModelInfo {
  id: string;
  name: string;
  /** Milliseconds since 1970. */
  created: number;
  modified: number;
  pictures: number;
  parts: number;
  /** Size of its history as text, without the photos. */
  bytes: number;
}

/** Every failure of the API rejects with this: a sentence for a person, and a code for a program. */
export interface SpineLoftFailure extends Error {
  /** Name of the engine's error, such as "StrokeTooShort" or "PictureTruncated". */
  code: string;
}

/** A model in a link. */
export interface SharedLink {
  /** The address of the viewer with the text behind '#m=': it shows the model, and "Make it mine" opens a copy of it here. */
  url: string;
  /** The text alone: letters, digits, '-' and '_'. */
  text: string;
  /** Length of the text. */
  characters: number;
  /** Photos that are not in it: white paper stands for each, and parts have its mean colour. The ribs found in a photo are fixed in any case. */
  photosLeft: number;
  /** True where the text is an id and a key of the server of this page's host, which keeps the model for some days. */
  stored: boolean;
}

export interface SpineLoftApi {
  /** Version of the page. */
  readonly version: string;
  /** Resolves when the engine runs; rejects when this browser cannot run it. */
  readonly ready: Promise<void>;
  /** Resolves when no work is pending and what is on the screen is up to date. */
  idle(): Promise<void>;
  /** Opens a picture file (PNG, JPEG, WebP, GIF, BMP, AVIF) as dropping it would. */
  openImage(blob: Blob, name?: string): Promise<void>;
  /** Opens a model file (.spineloft, a GLB of this page, or a PNG with a model inside) as a new model; the one that was open stays in the list. */
  openProject(blob: Blob): Promise<void>;
  /** The model as a link that holds all of it but its photos; with `photos` also copies of them of at most 512 pixels a side, which make it long; with `stored` as a short link with its photos as they are, where the host has a share server. */
  shareLink(options?: { stored?: boolean; photos?: boolean }): Promise<SharedLink>;
  /** Deletes what a stored link of this browser (its address or text) leads to. */
  takeBackLink(text: string): Promise<void>;
  /** Opens the model of such a link (stored or not), or of its text, as a new model; the one that was open stays in the list. */
  openShareText(text: string): Promise<void>;
  /** The models that this device keeps, the last changed first; `run('open-model', {id})` opens one. */
  models(): Promise<KeptModelInfo[]>;
  /** The open model with every step of undo and redo, as the text that the page keeps; photos are named by their hashes. */
  history(): string;
  /** Bytes that the memories of the engine, of the solver of solids and of what cuts things out have grown to; they never shrink. */
  memory(): { engine: number; solver: number; cutter: number };
  /** Where a picture pixel is on the page now, in client CSS pixels. */
  imageToClient(x: number, y: number): { x: number; y: number };
  /** What is on the page now. */
  state(): State;
  /** The command table: what can be run, and whether it can be run now. */
  commands(): Command[];
  /** Runs a command of the table by its id; resolves when the page shows what it did (work may go on: `idle()`). */
  run(id: string, args?: Record<string, unknown>): Promise<void>;
  /** All visible parts as the bytes of a file; waits for solids and for parts that are still searched for. */
  exportModel(format: ExportFormat): Promise<Uint8Array>;
}

declare global {
  interface Window {
    spineloft: SpineLoftApi;
  }
}
