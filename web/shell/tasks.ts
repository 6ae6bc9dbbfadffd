// Things to make, step by step: one sentence for each, and how the page sees that it is done.
import type { ShellView } from './shell_view.ts';
import { kExamples } from './task_drawings.ts';
import type { Example } from './task_drawings.ts';

export interface TaskStep {
  say: string;
  /** What the ghost hand shows until it is done; of several lines one after the other, as parts follow the first. */
  examples?: Example[];
  /** The command that answers what the page asks on the way; whatever else it asks comes before the step. */
  answers?: string;
  /** Whether it is done, `now` as against how things were when the task began. */
  done(now: ShellView, start: ShellView): boolean;
  /** Whether it can be done with what is selected; until then the steps after it are told. */
  can?(now: ShellView): boolean;
}

export interface Task {
  id: string;
  title: string;
  minutes: number;
  /** What it begins with: a sample by its id, or paper. */
  on: string;
  /** The command for the tool that its first step needs, where that is not the one that the page gives. */
  tool?: string;
  /** One sentence about how to begin. */
  start: string;
  steps: TaskStep[];
}

type Done = TaskStep['done'];

const turned: Done = (now) => now.turned;
const saved: Done = (now) => now.parts > 0 && !now.unsaved;
const parts =
  (count: number): Done =>
  (now) =>
    now.parts >= count;
const joined: Done = (now, start) => now.solids > start.solids;
const hollow: Done = (now, start) => now.hollow > start.hollow;
const mirrored: Done = (now, start) => now.mirrored > start.mirrored;
const hasBone = (now: ShellView): boolean => !now.selected || now.selected.kind === 'loft';
const otherShape: Done = (now) => now.shaped > 0;
const outlined: Done = (now) => now.parts > 0 || now.picture?.finished === true;

const stick: TaskStep = { say: 'Press Stick: the parts become one', done: joined };
const save: TaskStep = { say: 'Press Save to keep it as a file', done: saved };
const turn: TaskStep = { say: 'Drag beside the solid to turn it round', done: turned };
const scoop: TaskStep = { say: 'Press Scoop out, then Make it hollow', done: hollow, answers: 'hollow-use' };
const outline = (say: string, example: Example): TaskStep => ({ say, done: outlined, examples: [example] });
const { sausage, vase, mug, bird, robot } = kExamples;

/** What the first visit is led through after its first part. */
export const kFirstVisit: TaskStep[] = [
  turn,
  { say: 'Choose another slice: a star, a square …', done: otherShape, can: hasBone },
  { say: 'Draw another line: it makes a second part', done: parts(2) },
  stick,
  save,
];

export const kTasks: Task[] = [
  {
    id: 'sausage',
    title: 'A sausage',
    minutes: 2,
    on: 'paper',
    start: 'Begin with Draw on paper.',
    steps: [
      outline('Draw the outline of a long sausage with the pen', sausage[0]),
      { say: 'Draw a line from end to end', done: parts(1), examples: [sausage[1]] },
      turn,
      save,
    ],
  },
  {
    id: 'vase',
    title: 'A vase',
    minutes: 4,
    on: 'paper',
    start: 'Begin with Draw on paper.',
    steps: [
      outline('Draw the outline of a vase with the pen', vase[0]),
      { say: 'Draw a line down its middle, from the rim to the foot', done: parts(1), examples: [vase[1]] },
      scoop,
      turn,
      save,
    ],
  },
  {
    id: 'mug',
    title: 'A mug with a handle',
    minutes: 6,
    on: 'paper',
    start: 'Begin with Draw on paper.',
    steps: [
      outline('Draw the outline of a mug, without its handle, with the pen', mug[0]),
      { say: 'Draw a line down its middle', done: parts(1), examples: [mug[1]] },
      scoop,
      { say: 'Draw a line for the handle, from the mug and back to it', done: parts(2), examples: [mug[2]] },
      { say: 'Press Stick: mug and handle become one', done: (now, start) => now.solids >= start.solids + 2 },
      save,
    ],
  },
  {
    id: 'zucchini',
    title: 'A zucchini behind a hand',
    minutes: 3,
    on: 'zucchini',
    start: 'Begin with the picture of the zucchini: the hand may stay in front of it.',
    steps: [{ say: 'Draw a line along the zucchini, also under the fingers', done: parts(1) }, turn, save],
  },
  {
    id: 'bird',
    title: 'A bird with two wings',
    minutes: 8,
    on: 'paper',
    start: 'Begin with Draw on paper.',
    steps: [
      outline('Draw the outline of a bird from the side with the pen', bird[0]),
      { say: 'Take Puff, tap the bird and press Use this: it swells', done: parts(1), answers: 'cut-use' },
      { say: 'With Puff, draw a line round a wing on it', done: parts(2), examples: [bird[1]] },
      { say: 'Choose Symmetry: the wing comes on the other side, too', done: mirrored },
      stick,
      save,
    ],
  },
  {
    id: 'robot',
    title: 'A robot',
    minutes: 10,
    on: 'paper',
    tool: 'draw',
    start: 'Begin with Draw on paper.',
    steps: [
      { say: 'Draw a line for the body', done: parts(1), examples: [robot[0]] },
      { say: 'Choose the square as its slice', done: otherShape },
      { say: 'Draw lines for head, arms and legs', done: parts(4), examples: robot.slice(1) },
      stick,
      { say: 'Choose Check for printing in More', done: (now) => now.checked },
      save,
    ],
  },
];

/** Follows what is done of a list of steps, in any order: what was done once stays done. */
export class Steps {
  private readonly done: Set<TaskStep> = new Set();

  constructor(
    readonly steps: TaskStep[],
    private readonly start: ShellView,
  ) {}

  /** Whether every step is done, as of the last `next`. */
  get areDone(): boolean {
    return this.steps.every((step) => this.done.has(step));
  }

  /** The first step that is not done and can be; null: all are done, or none of the others can be. */
  next(now: ShellView): TaskStep | null {
    for (const step of this.steps) if (step.done(now, this.start)) this.done.add(step);
    return this.steps.find((step) => !this.done.has(step) && step.can?.(now) !== false) ?? null;
  }

  /** The number of a step in the list, as Help shows it. */
  place(step: TaskStep): number {
    return this.steps.indexOf(step) + 1;
  }
}
