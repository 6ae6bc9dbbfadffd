// What the operands of a step make together, from what of it is there already. Where some of them alone are edited,
// what the others make is kept, and united with the edited ones by what is near these.
import type { Manifold } from 'manifold-3d';
import type { Keyed, Kept, Made, Scratch } from './kept.ts';
import { isPart, isWorthKeeping, joinKey, keysOf, restKey } from './names.ts';
import { Near } from './near.ts';
import type { Tools } from './parts.ts';
import type { PartOperand, SolidKind, SolidNode } from './protocol.ts';
import type { Shape } from './room.ts';
import type { SolidStore } from './solid_store.ts';

/** More operands than this are united in groups, so that an edit of one leaves the unions of other groups. */
const kFew = 6;
const kIdentity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** A step's operands, of which some are edited. */
export interface Edit {
  kind: SolidKind;
  all: Keyed[];
  /** By operand. */
  changed: boolean[];
}

const changedOf = ({ all, changed }: Edit) => all.filter((_, i) => changed[i]);
const othersOf = ({ all, changed }: Edit) => all.filter((_, i) => !changed[i]);
const keyOf = (edit: Edit) => restKey(edit.kind, othersOf(edit), edit.changed);
const solidsOf = (all: Keyed[]) => all.map(({ solid }) => solid());

function drain(work: Generator<void, void>): void {
  while (!work.next().done);
}

export class Booleans {
  /** What each step was made of last. */
  private readonly last = new Map<number, { keys: Set<string>; rest: string }>();

  constructor(
    private readonly tools: Tools,
    private readonly store: SolidStore,
  ) {}

  /** All operands as the step says; `asSolid`: another step needs it, so that faces alone do not do. */
  combine({ step, kind }: SolidNode, all: Keyed[], { own }: Scratch, asSolid: boolean): Made {
    const before = this.last.get(step),
      edit = { kind, all, changed: all.map(({ key }) => !before?.keys.has(key)) },
      key = keyOf(edit);
    this.last.set(step, { keys: new Set(keysOf(all)), rest: key });
    if (isWorthKeeping(kind, edit.changed)) {
      // The second edit of the same operands: now it pays.
      if (before?.rest === key) drain(this.makeRest(edit));
      const made = this.edited(edit, key, own, asSolid);
      if (made) return made;
    }
    return { solid: this.whole(kind, all) };
  }

  /** Makes what such an edit will count on, a piece at a time. */
  *prepare(edit: Edit): Generator<void, void> {
    yield* this.makeRest(edit);
    const rest = this.store.get(keyOf(edit))!,
      shapes = this.shapesOf(edit);
    if (!rest.solid || rest.near === null || rest.near?.holds(shapes)) return;
    const near = yield* Near.of(this.tools.library, rest.solid, shapes);
    rest.near?.solid.delete();
    rest.near = near;
  }

  /** The union of all, as a solid that is kept. */
  union(of: Keyed[]): Manifold {
    const { Manifold } = this.tools.library;
    if (of.length === 1) return of[0]!.solid();
    return this.store.keep(joinKey(of), of, () => Manifold.union(solidsOf(of)), keysOf(of));
  }

  /** From what the other operands make; null where that is not there, or does not do. */
  private edited(edit: Edit, key: string, own: Manifold[], asSolid: boolean): Made | null {
    const rest = this.store.get(key);
    if (!rest) return null;
    this.store.use(rest).ahead = false;
    const near = this.withNear(rest, edit, asSolid);
    if (near) return near;
    const solid = this.withRest(rest.solid!, edit);
    if (solid.status() === 'NoError') return { solid };
    own.push(solid);
    return null;
  }

  private whole(kind: SolidKind, all: Keyed[]): Manifold {
    const { Manifold } = this.tools.library,
      [first, ...others] = all;
    if (kind === 'common') return Manifold.intersection(solidsOf(all));
    if (kind === 'join') return Manifold.union(this.groups(all).map((group) => this.union(group)));
    return first!.solid().subtract(this.union(others));
  }

  /** Many in a few groups: unions that are there, and others. */
  private groups(all: Keyed[]): Keyed[][] {
    const { made, left } = this.store.unionsOf(all),
      count = left.length < kFew ? left.length : Math.round(Math.sqrt(left.length)),
      start = (i: number) => Math.floor((i * left.length) / count);
    return [...made, ...Array.from({ length: count }, (_, i) => left.slice(start(i), start(i + 1)))];
  }

  /** What changed, to what the others make or to what is near of that. */
  private withRest(rest: Manifold, edit: Edit): Manifold {
    const { Manifold } = this.tools.library,
      { kind, changed } = edit,
      solids = solidsOf(changedOf(edit));
    if (kind === 'common') return Manifold.intersection([rest, ...solids]);
    if (kind === 'join') return Manifold.union([rest, ...solids]);
    return Manifold.difference(changed[0] ? [solids[0]!, rest, ...solids.slice(1)] : [rest, ...solids]);
  }

  /** The same by what is near alone; null where what changed goes beyond that. */
  private withNear({ near }: Kept, edit: Edit, asSolid: boolean): Made | null {
    // Nothing that is away is in what two have in common, or is left of the first operand of a cut.
    const isAll = edit.kind === 'common' || (edit.kind === 'cut' && edit.changed[0]!);
    if (!near || (asSolid && !isAll) || !near.holds(this.shapesOf(edit))) return null;
    const solid = this.withRest(near.solid, edit),
      isSound = solid.status() === 'NoError';
    if (isSound && isAll) return { solid };
    const faces = isSound ? near.withAway(solid.getMesh()) : null;
    solid.delete();
    return faces && faces.triVerts.length > 0 ? { faces } : null;
  }

  /** Where those are that changed. */
  private shapesOf(edit: Edit): Shape[] {
    return changedOf(edit).map(({ operand, solid }) => {
      const mesh = isPart(operand) ? this.store.parts.meshOf(operand.mesh) : undefined;
      if (mesh) return { positions: mesh.positions, matrix: (operand as PartOperand).matrix };
      const { min, max } = solid().boundingBox();
      return { positions: Float32Array.of(...min, ...max), matrix: kIdentity };
    });
  }

  /** Makes and keeps what the operands make that are not edited, a piece at a time, where it is not there. */
  private *makeRest(edit: Edit): Generator<void, void> {
    const { library } = this.tools,
      { kind } = edit,
      others = othersOf(edit),
      key = keyOf(edit);
    if (this.store.has(key)) return;
    if (kind === 'common') {
      this.store.keep(key, others, () => library.Manifold.intersection(solidsOf(others)));
      return;
    }
    const isCutFrom = kind === 'cut' && !edit.changed[0],
      added = isCutFrom ? others.slice(1) : others,
      before = this.store.keys();
    yield* this.pairUp(added);
    if (isCutFrom) this.store.keep(key, others, () => others[0]!.solid().subtract(this.union(added)));
    // What was only on the way to it.
    for (const name of this.store.keys()) if (!before.has(name) && name !== key) this.store.drop(name);
  }

  /** The union of all, two by two. */
  private *pairUp(all: Keyed[]): Generator<void, void> {
    const { made, left } = this.store.unionsOf(all);
    let row = [...made, ...left.map((each) => [each])];
    while (row.length > 1) {
      const next: Keyed[][] = [];
      for (let i = 0; i < row.length; i += 2) {
        const pair = row.slice(i, i + 2),
          of = pair.flat();
        next.push(of);
        if (pair.length < 2 || this.store.has(joinKey(of))) continue;
        this.store.keep(joinKey(of), of, () => this.union(pair[0]!).add(this.union(pair[1]!)), keysOf(of));
        yield;
      }
      row = next;
    }
  }
}
