// The solver of steps: parts in their places → solids, on manifold-3d. Every sub-result is kept under its key,
// so that an edited part is fused again without redoing what did not change. Runs in a worker; knows no page.
import type { Manifold, ManifoldToplevel } from 'manifold-3d';
import { hollowOf, seamOf } from './fields.ts';
import { withoutFlaps } from './flaps.ts';
import type { Faces } from './flaps.ts';
import { blamed } from './blame.ts';
import { halvesOf, kWorthSharing } from './helper.ts';
import { madeOf } from './kept.ts';
import type { Bench, Kept, Keyed, Made } from './kept.ts';
import { isPart, isPlain, isRound, isWorthKeeping, joinKey, keysOf, pairsOf, restKey, seamKey } from './names.ts';
import { Near } from './near.ts';
import { fitPaint } from './paint.ts';
import { PartStore } from './part_store.ts';
import { crossesItself, fromMesh } from './parts.ts';
import { sizeOf } from './sizes.ts';
import { isSpeck, withoutSpecks } from './specks.ts';
import { carried, runsOf } from './sources.ts';
import type { Source } from './sources.ts';
import { countOf } from './topology.ts';
import { inWorld } from './rooms.ts';
import type { Shape } from './rooms.ts';
import { Unsolvable, failureOf } from './unsolvable.ts';
import type {
  MeshData,
  PartOperand,
  SharedUnion,
  ShareRequest,
  SolidFailure,
  SolidMesh,
  SolidNode,
  SolidOperand,
  SolveRequest,
} from './protocol.ts';

/** How often the way of an edit is gone before the first one, so that it runs at its quickest. */
const kTries = 8;

/** A second worker; see helper.ts. */
export interface Sharer {
  readonly isFree: boolean;
  unite(operands: PartOperand[], meshes: Record<string, MeshData>): Promise<SharedUnion | null>;
}

/** Between two pieces of work; what there is to wait for. */
export interface Pause {
  done: number;
  wait?: Promise<unknown>;
}

export interface Solved {
  node: SolidNode;
  ms: number;
  mesh?: SolidMesh;
  failure?: SolidFailure;
}

function drain(work: Generator<void, void>): void {
  while (!work.next().done);
}

export class SolidKernel {
  private readonly solids = new Map<string, Kept>();
  /** What each step was made of last. */
  private readonly lastOperands = new Map<number, { keys: Set<string>; rest: string }>();
  /** What was solved last. */
  private nodes: SolidNode[] = [];
  private tries = 0;
  /** What is likely to be asked for next: what it is made of, and its mesh, once. */
  private likelyOf: string[] = [];
  private likelyMesh: { name: string; mesh: SolidMesh } | null = null;

  private readonly parts: PartStore;

  constructor(
    private readonly library: ManifoldToplevel,
    private readonly sharer: Sharer | null = null,
    private readonly now: () => number = () => performance.now(),
  ) {
    this.parts = new PartStore(library);
  }

  keepMeshes(meshes: SolveRequest['meshes']): void {
    this.parts.keepMeshes(meshes);
  }

  /** Solves what is wanted, one node after the other, and hands out each as it is done; between two it can be given up. */
  *solve(request: SolveRequest, done: (solved: Solved) => void): Generator<Pause, void> {
    this.parts.round += 1;
    this.nodes = request.nodes;
    this.keepMeshes(request.meshes);
    for (const node of request.nodes)
      for (const operand of node.operands) if (isPart(operand)) this.parts.touch(operand.mesh);
    for (const [index, node] of request.nodes.entries()) {
      const started = this.now();
      const key = node.coarse ? `${node.key}~` : node.key;
      const isOperand = request.nodes.some(({ operands }) =>
          operands.some((operand) => !isPart(operand) && operand.node === node.key),
        ),
        known = this.solids.get(key);
      if (!known) yield* this.share(node, index / request.nodes.length);
      const kept = known && !(known.faces && isOperand) ? known : this.make(node, isOperand);
      this.use(kept);
      this.solids.set(key, kept);
      if (request.wanted.includes(node.key)) done(this.finish(node, kept, started));
      yield { done: (index + 1) / request.nodes.length };
    }
    this.likelyOf = [];
    this.forget();
  }

  /** Keeps what is asked for, and what it was made from. */
  private use(kept: Kept): Kept {
    const { round } = this.parts;
    if (kept.round !== round) {
      kept.round = round;
      kept.from?.forEach((each) => this.use(each));
    }
    return kept;
  }

  private finish(node: SolidNode, kept: Kept, started: number): Solved {
    if (!kept.solid && !kept.faces)
      return { node, ms: this.now() - started, ...(kept.failure ? { failure: kept.failure } : {}) };
    const likely = this.likelyMesh;
    // It goes to whoever asked, and is not here any more.
    this.likelyMesh = null;
    if (likely && likely.name === kept.name) return { node, mesh: likely.mesh, ms: this.now() - started };
    try {
      const mesh = kept.faces ? this.meshOf(kept.faces, sizeOf(kept.faces)) : this.meshOfSolid(kept.solid!);
      return { node, mesh, ms: this.now() - started };
    } catch (thrown) {
      return { node, ms: this.now() - started, failure: failureOf(thrown) };
    }
  }

  /** Has a second worker make one half of a large union of parts that are new while this one makes the other. */
  private *share(node: SolidNode, done: number): Generator<Pause, void> {
    const fresh = node.operands.filter(
      (operand) => isPart(operand) && !this.parts.known(operand) && this.parts.meshOf(operand.mesh),
    ) as PartOperand[];
    const meshOf = (operand: PartOperand) => this.parts.meshOf(operand.mesh)!,
      count = fresh.reduce((sum, operand) => sum + meshOf(operand).triangles.length / 3, 0);
    if (
      !this.sharer?.isFree ||
      node.kind !== 'join' ||
      node.coarse ||
      node.blend > 0 ||
      fresh.length < 4 ||
      count < kWorthSharing
    )
      return;
    const [own, given] = halvesOf(fresh, meshOf),
      bench: Bench = { own: [], ids: [], from: [] };
    if (Math.min(own.length, given.length) < 2) return;
    let union = null as SharedUnion | null;
    const wait = this.sharer
      .unite(given, Object.fromEntries(given.map((operand) => [operand.mesh, meshOf(operand)])))
      .then((made) => {
        union = made;
      });
    try {
      const half: Keyed[] = [];
      for (const operand of own) {
        half.push(this.operand(operand, false, bench));
        // A worker that has yet to start waits until this one lets it.
        yield { done };
      }
      this.union(half);
      yield { done, wait };
      if (union) this.takeShare(union, given);
    } catch (thrown) {
      // The step says so itself, when it meets with the same part.
      failureOf(thrown);
    } finally {
      for (const solid of bench.own) solid.delete();
    }
  }

  private takeShare({ faces, sources }: SharedUnion, given: PartOperand[]): void {
    const bench: Bench = { own: [], ids: [], from: [] },
      ids = new Map(sources.map(({ id, operand, mesh }) => [id, this.parts.adopt(operand, mesh)]));
    const solid = this.library.Manifold.ofMesh(
      new this.library.Mesh({ numProp: 3, ...faces, runOriginalID: faces.runOriginalID.map((id) => ids.get(id)!) }),
    );
    if (solid.status() !== 'NoError') {
      solid.delete();
      return;
    }
    const of = given.map((operand) => this.operand(operand, false, bench));
    this.keep(joinKey(of), of, () => solid, keysOf(of));
  }

  /** In the second worker: the union of a share, and nothing that is kept. Null where a part is at fault. */
  unite({ operands, meshes }: ShareRequest): SharedUnion | null {
    const bench: Bench = { own: [], ids: [], from: [] };
    this.keepMeshes(meshes);
    try {
      const union = this.union(operands.map((operand) => this.operand(operand, false, bench))),
        { vertProperties, triVerts, runIndex, runOriginalID, runTransform, faceID } = union.getMesh();
      const sources = [...new Set(runOriginalID)].map((id) => {
        const source = this.parts.sources.get(id) as Source & { mesh: MeshData },
          operand = operands.find((each) => this.parts.known(each)!.ids!.includes(id))!;
        return { id, operand, mesh: source.mesh === meshes[operand.mesh] ? null : source.mesh };
      });
      return union.status() === 'NoError'
        ? { faces: { vertProperties, triVerts, runIndex, runOriginalID, runTransform, faceID }, sources }
        : null;
    } catch (thrown) {
      failureOf(thrown);
      return null;
    } finally {
      for (const solid of bench.own) solid.delete();
      this.forgetAll();
    }
  }

  private make(node: SolidNode, isOperand: boolean): Kept {
    const bench: Bench = { own: [], ids: [], from: [] },
      { own, ids, from } = bench;
    const { round } = this.parts;
    let all: Keyed[] = [];
    try {
      all = this.operandsOf(node, bench);
      const made = this.combine(node, all, bench, isOperand),
        name = isPlain(node) ? { name: joinKey(all) } : {};
      if ('faces' in made) return { solid: null, faces: made.faces, round, ids, from };
      const { solid, cavity, free } = made;
      const error =
        solid.status() !== 'NoError' ? 'SolidFailed' : this.isNothing(solid, node, all) ? 'SolidEmpty' : null;
      if (error) {
        own.push(solid, ...(cavity ? [cavity] : []));
        throw new Unsolvable({ error });
      }
      return { solid, round, ids, from, ...name, ...(cavity ? { cavity } : {}), ...(free.length > 0 ? { free } : {}) };
    } catch (thrown) {
      const failure = blamed(
        this.library,
        failureOf(thrown),
        node.kind,
        all,
        (solid) => this.likeness(solid, { ids }).part,
      );
      return { solid: null, failure, round, ids };
    } finally {
      for (const solid of own) solid.delete();
    }
  }

  /** Whether nothing is left of the operands, or what is as thin as rounding. */
  private isNothing(solid: Manifold, { kind }: SolidNode, [first]: Keyed[]): boolean {
    if (solid.isEmpty() || kind === 'join') return solid.isEmpty();
    const { min, max } = first!.solid().boundingBox();
    return isSpeck(
      { volume: solid.volume(), area: solid.surfaceArea() },
      Math.hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]),
    );
  }

  /**
   * What a step is made of. Where it only sticks together, each is without the insides of the others beforehand: that cuts
   * a handle, while cutting all of it in the end would go along the whole inside of the mug.
   */
  private operandsOf(node: SolidNode, bench: Bench): Keyed[] {
    const all = node.operands.map((operand) => this.operand(operand, node.coarse, bench));
    if (node.kind !== 'join' || node.blend > 0) return all;
    const insides = node.operands.map((operand) => this.freeIn(operand, node));
    return all.map((each, i) => {
      const free = insides.flatMap((inside, k) => (k === i ? [] : inside)),
        beside = all.filter((_, k) => k !== i && insides[k]!.length > 0);
      let cut: Manifold | null = null;
      const make = () => {
        cut = this.library.Manifold.difference([each.solid(), ...free]);
        bench.own.push(cut);
        return cut;
      };
      return free.length === 0
        ? each
        : { ...each, key: `${each.key} beside ${keysOf(beside).join(' ')}`, solid: () => cut ?? make() };
    });
  }

  /** An operand in its place; what is made for it alone goes into `own`. */
  private operand(operand: SolidOperand, coarse: boolean, { own, from }: Bench): Keyed {
    if (!isPart(operand)) {
      const key = coarse ? `${operand.node}~` : operand.node,
        kept = this.solids.get(key),
        solid = kept?.solid;
      if (!solid) throw new Unsolvable(kept?.failure ?? { error: 'SolidFailed' });
      from.push(this.use(kept));
      return { operand, key, solid: () => solid, from: kept };
    }
    const kept = this.parts.of(operand, coarse);
    from.push(this.use(kept));
    if (!kept.solid && !kept.waiting)
      throw new Unsolvable({
        ...kept.failure!,
        ...(kept.failure!.at ? { at: inWorld(operand.matrix, kept.failure!.at) } : {}),
      });
    let placed: Manifold | null = null;
    const place = () => {
      placed = this.parts.solidOf(kept).transform(operand.matrix as Parameters<Manifold['transform']>[0]);
      own.push(placed);
      return placed;
    };
    return { operand, key: this.parts.nameOf(operand), solid: () => placed ?? place(), from: kept };
  }

  private combine(
    node: SolidNode,
    operands: Keyed[],
    bench: Bench,
    isOperand: boolean,
  ): { solid: Manifold; cavity?: Manifold; free: Manifold[] } | { faces: Faces } {
    const { own } = bench;
    if (node.kind === 'hollow') {
      // A part with live symmetry comes with its twin.
      const body =
        operands.length > 1 ? this.library.Manifold.union(operands.map(({ solid }) => solid())) : operands[0]!.solid();
      if (operands.length > 1) own.push(body);
      const { shell, cavity } = hollowOf(this.library, body, node, { ...this.likeness(body, bench), own });
      return { solid: shell, cavity, free: [cavity] };
    }
    const free = node.kind === 'join' ? node.operands.flatMap((operand) => this.freeIn(operand, node)) : [],
      isRounded = isRound(node);
    const made = this.together(
      node,
      [...operands, ...this.roundings(node, operands, bench)],
      bench,
      isOperand || (isRounded && free.length > 0),
    );
    if ('faces' in made) return made;
    if (!isRounded || free.length === 0) return { ...made, free };
    own.push(made.solid);
    return { solid: this.library.Manifold.difference([made.solid, ...free]), free };
  }

  /** For new faces that look as a solid does: the part that most of it is from, and its picture as it lies on it. */
  private likeness(solid: Manifold, { ids }: Pick<Bench, 'ids'>): { id: number; part: number } {
    const mesh = solid.getMesh(),
      { positions, uv } = carried(mesh, this.parts.sources),
      { part } = runsOf(mesh, this.parts.sources).reduce((most, run) => (run.count > most.count ? run : most), {
        part: 0,
        count: -1,
      });
    return { id: this.parts.register({ part, paint: fitPaint(positions, uv) }, ids), part };
  }

  /** What rounds the seams of a step: one for every two operands that meet. What was made for as much as these two is made no more. */
  private roundings(node: SolidNode, operands: Keyed[], { from }: Bench): Keyed[] {
    return !isRound(node)
      ? []
      : pairsOf(node.kind, operands).flatMap(([one, other]) => {
          // Where it is there a preview has the fine one, too.
          const fine = seamKey({ ...node, coarse: false }, one, other),
            key = this.solids.has(fine) ? fine : seamKey(node, one, other);
          const kept = this.solids.get(key) ?? {
            ...this.rounding(node, one.solid(), other.solid()),
            round: this.parts.round,
          };
          this.solids.set(key, kept);
          from.push(this.use(kept));
          return kept.solid
            ? [{ operand: { node: key }, key, solid: () => kept.solid!, from: kept, of: [one, other] }]
            : [];
        });
  }

  private rounding(node: SolidNode, one: Manifold, other: Manifold): Pick<Kept, 'solid' | 'ids'> {
    const ids: number[] = [],
      own: Manifold[] = [];
    try {
      return {
        solid: seamOf(this.library, { one, other, node, idOf: (operand) => this.likeness(operand, { ids }).id }, own),
        ids,
      };
    } finally {
      for (const solid of own) solid.delete();
    }
  }

  /** The insides of a hollow operand: the end of a handle does not stand into its mug. */
  private freeIn(operand: SolidOperand, { coarse }: SolidNode): Manifold[] {
    return isPart(operand) ? [] : (this.solids.get(coarse ? `${operand.node}~` : operand.node)?.free ?? []);
  }

  /**
   * All operands as the step says. Where some alone are others than last time, what the rest makes is kept (or was made
   * ahead): the next time that these change there is a single thing left to do.
   */
  private together(node: SolidNode, all: Keyed[], { own }: Bench, asSolid: boolean): Made {
    const { kind } = node;
    const before = this.lastOperands.get(node.step),
      changed = all.map(({ key }) => !before?.keys.has(key));
    const key = restKey(
        kind,
        all.filter((_, i) => !changed[i]),
        changed,
      ),
      again = before?.rest === key;
    this.lastOperands.set(node.step, { keys: new Set(keysOf(all)), rest: key });
    const anew = () => ({ solid: this.whole(kind, all) });
    if (!isWorthKeeping(kind, changed)) return anew();
    if (again && !this.solids.has(key)) drain(this.rest(kind, all, changed));
    const kept = this.solids.get(key);
    if (!kept) return anew();
    this.use(kept).ahead = false;
    const near = this.withNear(kept, kind, all, changed, asSolid);
    if (near) return near;
    const solid = this.withRest(kept.solid!, kind, all, changed);
    if (solid.status() === 'NoError') return { solid };
    own.push(solid);
    return anew();
  }

  private whole(kind: SolidNode['kind'], all: Keyed[]): Manifold {
    const { Manifold } = this.library,
      [first, ...others] = all;
    if (kind === 'common') return Manifold.intersection(all.map(({ solid }) => solid()));
    if (kind === 'join') return Manifold.union(this.groups(all).map((group) => this.union(group)));
    return first!.solid().subtract(this.union(others));
  }

  /** What changed to what the others make. */
  private withRest(rest: Manifold, kind: SolidNode['kind'], all: Keyed[], changed: boolean[]): Manifold {
    const { Manifold } = this.library,
      solids = all.filter((_, i) => changed[i]).map(({ solid }) => solid());
    if (kind === 'common') return Manifold.intersection([rest, ...solids]);
    if (kind === 'join') return Manifold.union([rest, ...solids]);
    return Manifold.difference(changed[0] ? [solids[0]!, rest, ...solids.slice(1)] : [rest, ...solids]);
  }

  /** The same by what is near alone; null where what changed goes beyond that. */
  private withNear(
    { near }: Kept,
    kind: SolidNode['kind'],
    all: Keyed[],
    changed: boolean[],
    asSolid: boolean,
  ): Made | null {
    // Nothing that is away is in what two have in common, or is left of the first one.
    const isAll = kind === 'common' || (kind === 'cut' && changed[0]!);
    if (!near || (asSolid && !isAll) || !near.holds(this.shapes(all, changed))) return null;
    const solid = this.withRest(near.solid, kind, all, changed),
      isSound = solid.status() === 'NoError';
    if (isSound && isAll) return { solid };
    const faces = isSound ? near.withAway(solid.getMesh()) : null;
    solid.delete();
    return faces && faces.triVerts.length > 0 ? { faces } : null;
  }

  /** Where those are that changed. */
  private shapes(all: Keyed[], changed: boolean[]): Shape[] {
    return all
      .filter((_, i) => changed[i])
      .map(({ operand, solid }) => {
        const mesh = isPart(operand) ? this.parts.meshOf(operand.mesh) : undefined;
        if (mesh) return { positions: mesh.positions, matrix: (operand as PartOperand).matrix };
        const { min, max } = solid().boundingBox();
        return { positions: Float32Array.of(...min, ...max), matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1] };
      });
  }

  /**
   * Makes and keeps what those make together that did not change, a piece at a time. What is only on the way to it is let
   * go at the end.
   */
  private *rest(kind: SolidNode['kind'], all: Keyed[], changed: boolean[]): Generator<void, void> {
    const others = all.filter((_, i) => !changed[i]),
      key = restKey(kind, others, changed),
      before = new Set(this.solids.keys());
    if (kind === 'common') {
      this.keep(key, others, () => this.library.Manifold.intersection(others.map(({ solid }) => solid())));
      return;
    }
    const isCutFrom = kind === 'cut' && !changed[0],
      added = isCutFrom ? others.slice(1) : others;
    const { made, left } = madeOf(this.solids.values(), added);
    let row = [...made, ...left.map((each) => [each])];
    while (row.length > 1) {
      const next: Keyed[][] = [];
      for (let i = 0; i < row.length; i += 2) {
        const pair = row.slice(i, i + 2),
          of = pair.flat();
        next.push(of);
        if (pair.length < 2 || this.solids.has(joinKey(of))) continue;
        this.keep(joinKey(of), of, () => this.union(pair[0]!).add(this.union(pair[1]!)), keysOf(of));
        yield;
      }
      row = next;
    }
    if (isCutFrom) this.keep(key, others, () => others[0]!.solid().subtract(this.union(added)));
    for (const [name, kept] of this.solids) {
      if (before.has(name) || name === key) continue;
      this.solids.delete(name);
      this.letGo(kept);
    }
  }

  /**
   * Makes what an edit of this part will count on, a piece at a time; null: of none. What was made ahead for another part
   * and never needed is let go.
   */
  *ahead(part: number | null): Generator<void, void> {
    for (const [key, kept] of this.solids) {
      if (!kept.ahead || kept.ahead === part) continue;
      this.solids.delete(key);
      this.letGo(kept);
    }
    const touched = new Set<string>();
    for (const node of part === null ? [] : this.nodes) {
      const changed = node.operands.map((operand) =>
        isPart(operand) ? operand.part === part : touched.has(operand.node),
      );
      if (changed.includes(true)) touched.add(node.key);
      if (!isWorthKeeping(node.kind, changed) || !node.operands.every((operand) => this.isHere(operand))) continue;
      const bench: Bench = { own: [], ids: [], from: [] },
        known = new Set(this.solids.keys());
      try {
        const operands = this.operandsOf({ ...node, coarse: false }, bench),
          all = [...operands, ...this.roundings({ ...node, coarse: false }, operands, bench)];
        for (const { of } of all.slice(operands.length))
          changed.push(operands.some((each, i) => changed[i] && of?.includes(each)));
        const key = restKey(
          node.kind,
          all.filter((_, i) => !changed[i]),
          changed,
        );
        if (!this.solids.has(key)) yield* this.rest(node.kind, all, changed);
        const kept = this.solids.get(key)!;
        yield* this.comeNear(kept, this.shapes(all, changed));
        if (kept.solid) yield* this.tryOut(kept, node.kind, all, changed);
      } catch (thrown) {
        // The edit says so itself.
        failureOf(thrown);
      } finally {
        for (const [key, kept] of this.solids) if (!known.has(key)) kept.ahead = part!;
        for (const solid of bench.own) solid.delete();
      }
    }
  }

  /**
   * Makes the parts that the last node sticks together, their union and its mesh, a piece at a time: whoever asks for it,
   * or for more than that, finds it. What was made so before, and is of no use any more, is let go.
   */
  *likely({ nodes, meshes }: Pick<SolveRequest, 'nodes' | 'meshes'>): Generator<void, void> {
    const node = nodes.at(-1),
      before = new Set(this.kept()),
      bench: Bench = { own: [], ids: [], from: [] },
      all: Keyed[] = [];
    this.parts.round += 1;
    this.keepMeshes(meshes);
    if (!node || !isPlain(node) || !node.operands.every(isPart)) return;
    try {
      for (const operand of node.operands) {
        this.parts.touch(operand.mesh);
        all.push(this.operand(operand, false, bench));
        yield;
      }
      // What stays as it was comes first: an edit of the same part then has one union to make.
      const others = all.filter(({ key }) => this.likelyOf.includes(key)),
        name = joinKey(all);
      this.likelyOf = keysOf(all);
      for (const of of [others, all].filter(({ length }) => length > 1)) {
        yield* this.rest('join', of, []);
        this.use(this.solids.get(joinKey(of))!);
        yield;
      }
      const whole = this.solids.get(name)!.solid!;
      if (this.likelyMesh?.name !== name && whole.status() === 'NoError' && !whole.isEmpty())
        this.likelyMesh = { name, mesh: this.meshOfSolid(whole) };
    } catch (thrown) {
      // Whoever asks for it is told.
      failureOf(thrown);
    } finally {
      for (const solid of bench.own) solid.delete();
      for (const kept of this.kept()) if (!before.has(kept)) kept.likely = true;
      this.forget((kept) => kept.likely === true && kept.round !== this.parts.round);
    }
  }

  private kept(): Kept[] {
    return [...this.parts.values(), ...this.solids.values()];
  }

  /** Makes what is near these ready, where it is not. */
  private *comeNear(kept: Kept, shapes: Shape[]): Generator<void, void> {
    if (!kept.solid || kept.near === null || kept.near?.holds(shapes)) return;
    const { library } = this,
      near = yield* Near.of(library, kept.solid, shapes);
    kept.near?.solid.delete();
    kept.near = near;
  }

  /** Goes the way of an edit with parts as they are, a piece at a time, and keeps nothing of it: what runs for the first time is slow. */
  private *tryOut(kept: Kept, kind: SolidNode['kind'], all: Keyed[], changed: boolean[]): Generator<void, void> {
    for (const own: Manifold[] = []; this.tries < kTries; this.tries += 1) {
      try {
        for (const operand of all
          .filter((_, i) => changed[i])
          .map((each) => each.operand)
          .filter(isPart)) {
          const mesh = this.parts.meshOf(operand.mesh);
          if (mesh && !crossesItself(mesh))
            own.push(fromMesh(this.library, mesh, () => this.library.Manifold.reserveIDs(1)));
          yield;
        }
        const made = this.withNear(kept, kind, all, changed, false) ?? {
          solid: this.withRest(kept.solid!, kind, all, changed),
        };
        if ('solid' in made) own.push(made.solid);
        const faces = 'solid' in made ? made.solid.getMesh() : made.faces;
        yield;
        this.meshOf(faces, sizeOf(faces));
        yield;
      } finally {
        for (const solid of own.splice(0)) solid.delete();
      }
    }
  }

  /** Whether the solid of an operand was made before and is still there. */
  private isHere(operand: SolidOperand): boolean {
    const kept = isPart(operand) ? this.parts.known(operand) : this.solids.get(operand.node);
    return !!(kept?.solid || kept?.waiting);
  }

  /** Many in a few groups: what is there, and others which stay as they are when one of another group changes. */
  private groups(all: Keyed[]): Keyed[][] {
    const { made, left } = madeOf(this.solids.values(), all),
      count = left.length < 6 ? left.length : Math.round(Math.sqrt(left.length));
    return [
      ...made,
      ...Array.from({ length: count }, (_, i) =>
        left.slice(Math.floor((i * left.length) / count), Math.floor(((i + 1) * left.length) / count)),
      ),
    ];
  }

  private union(of: Keyed[]): Manifold {
    if (of.length === 1) return of[0]!.solid();
    return this.keep(joinKey(of), of, () => this.library.Manifold.union(of.map(({ solid }) => solid())), keysOf(of));
  }

  /** What some of a step's operands make. */
  private keep(key: string, of: Keyed[], make: () => Manifold, joined?: string[]): Manifold {
    const kept = this.solids.get(key) ?? {
      solid: make(),
      round: this.parts.round,
      from: of.map((each) => each.from),
      ...(joined ? { joined } : {}),
    };
    this.use(kept);
    this.solids.set(key, kept);
    // The library works when it is asked for something, and then for good.
    kept.solid!.status();
    return kept.solid!;
  }

  private meshOfSolid(solid: Manifold): SolidMesh {
    return this.meshOf(solid.getMesh(), { volume: solid.volume(), area: solid.surfaceArea() });
  }

  private meshOf(whole: Faces, size: { volume: number; area: number }): SolidMesh {
    const count = ({ vertProperties, triVerts }: Faces) => countOf(vertProperties.length / 3, triVerts);
    const { pieces, handles } = count(whole),
      sound = withoutFlaps(whole),
      mesh = pieces > 1 ? withoutSpecks(sound) : sound;
    return {
      ...carried(mesh, this.parts.sources),
      runs: runsOf(mesh, this.parts.sources),
      ...size,
      genus: mesh === sound ? handles : count(mesh).handles,
    };
  }

  /** Lets go of what was not asked for in a while, and of what is of no use. */
  private forget(isUseless: (kept: Kept) => boolean = () => false): void {
    this.parts.forget(isUseless, (kept) => this.letGo(kept));
    for (const [key, kept] of this.solids) {
      if (!this.parts.isOld(kept) && !isUseless(kept)) continue;
      this.solids.delete(key);
      this.letGo(kept);
    }
  }

  /** Lets go of all that was kept. */
  forgetAll(): void {
    this.parts.age();
    this.likelyMesh = null;
    this.forget();
  }

  private letGo(kept: Kept): void {
    for (const solid of [kept.solid, kept.cavity, kept.near?.solid]) solid?.delete();
    this.parts.unregister(kept.ids ?? []);
  }
}
