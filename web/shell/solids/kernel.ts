// The solver of steps: parts in their places → solids, on manifold-3d. Every sub-result is kept under its key,
// so that an edited part is fused again without redoing what did not change. Runs in a worker; knows no page.
import type { Manifold, ManifoldToplevel } from 'manifold-3d';
import { hollowOf, seamOf } from './fields.ts';
import { FaultyPart, fromMesh, importPart } from './parts.ts';
import type { MeshData, PartOperand, PartRun, SolidFailure, SolidMesh, SolidNode, SolidOperand, SolveRequest } from './protocol.ts';

/** How many requests long a sub-result is kept that nobody asks for. */
const kKept = 12;

/** A request cannot be solved further; nothing is broken. */
export class Unsolvable extends Error {
  constructor(readonly failure: SolidFailure) {
    super(failure.error);
  }
}

interface Kept {
  solid: Manifold | null;
  /** What was scooped out of it. */
  cavity?: Manifold;
  /** That, and what was scooped out of what it is joined from: it stays free. */
  free?: Manifold[];
  failure?: SolidFailure;
  round: number;
}

/** An operand in its place. */
interface Keyed {
  key: string;
  solid: Manifold;
}

export interface Solved {
  node: SolidNode;
  ms: number;
  mesh?: SolidMesh;
  failure?: SolidFailure;
}

const isPart = (operand: SolidOperand): operand is PartOperand => 'mesh' in operand;

export class SolidKernel {
  private readonly meshes = new Map<string, { data: MeshData; round: number }>();
  private readonly parts = new Map<string, Kept>();
  private readonly solids = new Map<string, Kept>();
  /** Original ids of manifold-3d, and whose faces they are. */
  private readonly owners = new Map<number, number>();
  /** What each step was made of last. */
  private readonly lastOperands = new Map<number, string[]>();
  private round = 0;

  constructor(private readonly library: ManifoldToplevel, private readonly now: () => number = () => performance.now()) {}

  keepMeshes(meshes: SolveRequest['meshes']): void {
    for (const [key, data] of Object.entries(meshes)) this.meshes.set(key, { data, round: this.round });
  }

  /** Solves what is wanted, one node after the other, and hands out each as it is done; between two it can be given up. */
  *solve(request: SolveRequest, done: (solved: Solved) => void): Generator<{ done: number }, void> {
    this.round += 1;
    this.keepMeshes(request.meshes);
    for (const node of request.nodes) for (const operand of node.operands) if (isPart(operand)) this.touch(operand.mesh);
    for (const [index, node] of request.nodes.entries()) {
      const started = this.now();
      const key = node.coarse ? `${node.key}~` : node.key;
      const kept = this.solids.get(key) ?? this.make(node);
      kept.round = this.round;
      this.solids.set(key, kept);
      if (request.wanted.includes(node.key)) done(this.finish(node, kept, started));
      yield { done: (index + 1) / request.nodes.length };
    }
    this.forget();
  }

  private touch(key: string): void {
    const mesh = this.meshes.get(key);
    if (mesh) mesh.round = this.round;
  }

  private finish(node: SolidNode, kept: Kept, started: number): Solved {
    if (!kept.solid) return { node, ms: this.now() - started, ...(kept.failure ? { failure: kept.failure } : {}) };
    try {
      const mesh = this.meshOf(kept.solid);
      return { node, mesh, ms: this.now() - started };
    } catch (thrown) {
      return { node, ms: this.now() - started, failure: failureOf(thrown) };
    }
  }

  private make(node: SolidNode): Kept {
    const own: Manifold[] = [];
    try {
      const operands = node.operands.map((operand) => this.operand(operand, node.coarse, own));
      const { solid, cavity, free } = this.combine(node, operands, own);
      const error = solid.status() !== 'NoError' ? 'SolidFailed' : solid.isEmpty() ? 'SolidEmpty' : null;
      if (error) {
        own.push(solid, ...(cavity ? [cavity] : []));
        throw new Unsolvable({ error });
      }
      return { solid, round: this.round, ...(cavity ? { cavity } : {}), ...(free.length > 0 ? { free } : {}) };
    } catch (thrown) {
      return { solid: null, failure: failureOf(thrown), round: this.round };
    } finally {
      for (const solid of own) solid.delete();
    }
  }

  /** The solid of an operand; what is made for it alone goes into `own`. */
  private operand(operand: SolidOperand, coarse: boolean, own: Manifold[]): Manifold {
    if (!isPart(operand)) {
      const kept = this.solids.get(coarse ? `${operand.node}~` : operand.node);
      if (!kept?.solid) throw new Unsolvable(kept?.failure ?? { error: 'SolidFailed' });
      kept.round = this.round;
      return kept.solid;
    }
    const key = `${operand.mesh}#${operand.part}`;
    // What the hand is at is not looked over for places where it crosses itself.
    const unchecked = coarse && !this.parts.has(key);
    const kept = this.parts.get(key) ?? this.parts.get(`${key}~`) ?? this.importPart(operand, unchecked);
    kept.round = this.round;
    this.parts.set(unchecked ? `${key}~` : key, kept);
    if (!kept.solid) throw new Unsolvable({ ...kept.failure!, ...(kept.failure!.at ? { at: inWorld(operand.matrix, kept.failure!.at) } : {}) });
    const placed = kept.solid.transform(operand.matrix as Parameters<Manifold['transform']>[0]);
    own.push(placed);
    return placed;
  }

  private importPart(operand: PartOperand, unchecked: boolean): Kept {
    const mesh = this.meshes.get(operand.mesh);
    if (!mesh) return { solid: null, failure: { error: 'SolidFailed', part: operand.part }, round: this.round };
    const id = this.ownerId(operand.part);
    try {
      return { solid: unchecked ? fromMesh(this.library, mesh.data, id) : importPart(this.library, mesh.data, id), round: this.round };
    } catch (thrown) {
      const failure = thrown instanceof FaultyPart ? { error: 'PartCrossesItself' as const, at: thrown.at } : failureOf(thrown);
      return { solid: null, failure: { ...failure, part: operand.part }, round: this.round };
    }
  }

  private ownerId(part: number): number {
    const id = this.library.Manifold.reserveIDs(1);
    this.owners.set(id, part);
    return id;
  }

  private combine(node: SolidNode, operands: Manifold[], own: Manifold[]): { solid: Manifold; cavity?: Manifold; free: Manifold[] } {
    const { Manifold } = this.library;
    if (node.kind === 'hollow') {
      // A part with live symmetry comes with its twin.
      const body = operands.length > 1 ? Manifold.union(operands) : operands[0]!;
      if (operands.length > 1) own.push(body);
      const part = this.mainPart(body);
      const { shell, cavity } = hollowOf(this.library, body, node, { id: this.ownerId(part), part, own });
      return { solid: shell, cavity, free: [cavity] };
    }
    const plain = this.together(node, operands, own);
    const solid = node.blend <= 0 || node.kind === 'common' || plain.isEmpty() ? plain : this.rounded(node, plain, operands, own);
    const free = node.kind === 'join' ? this.freeOf(node) : [];
    if (free.length === 0) return { solid, free };
    own.push(solid);
    return { solid: this.library.Manifold.difference([solid, ...free]), free };
  }

  private rounded(node: SolidNode, plain: Manifold, operands: Manifold[], own: Manifold[]): Manifold {
    own.push(plain);
    return seamOf(this.library, { plain, operands, node, idOf: (operand) => this.ownerId(this.mainPart(operand)) }, own);
  }

  /** The insides of hollow operands: the end of a handle does not stand into its mug. */
  private freeOf(node: SolidNode): Manifold[] {
    return node.operands.flatMap((operand) => (isPart(operand) ? [] : this.solids.get(node.coarse ? `${operand.node}~` : operand.node)?.free ?? []));
  }

  /**
   * All operands as the step says. Where one alone is another than last time, what the others make is kept: the next
   * time that one changes there is a single thing left to do.
   */
  private together(node: SolidNode, operands: Manifold[], own: Manifold[]): Manifold {
    const keys = node.operands.map((operand) => this.nameOf(operand, node.coarse));
    const before = this.lastOperands.get(node.step);
    this.lastOperands.set(node.step, keys);
    const changed = before?.length === keys.length ? keys.flatMap((key, i) => (key === before[i] ? [] : [i])) : [];
    const all = keys.map((key, i) => ({ key, solid: operands[i]! }));
    const one = keys.length >= 3 && changed.length === 1 ? changed[0]! : -1;
    const whole = one < 0 ? this.whole(node.kind, all) : this.withOne(node.kind, all, one);
    if (one < 0 || whole.status() === 'NoError') return whole;
    own.push(whole);
    return this.whole(node.kind, all);
  }

  /** Equal names, equal operands. What was not looked over is another thing than what was. */
  private nameOf(operand: SolidOperand, coarse: boolean): string {
    if (!isPart(operand)) return coarse ? `${operand.node}~` : operand.node;
    const key = `${operand.mesh}#${operand.part}`;
    return `${key}${this.parts.has(key) ? '' : '~'}@${operand.matrix.join()}`;
  }

  private whole(kind: SolidNode['kind'], all: Keyed[]): Manifold {
    const { Manifold } = this.library, [first, ...others] = all.map(({ solid }) => solid);
    if (kind === 'common') return Manifold.intersection([first!, ...others]);
    if (kind === 'join') return Manifold.union(this.groups(all).map((group) => this.union(group)));
    return first!.subtract(others.length > 1 ? this.union(all.slice(1)) : others[0]!);
  }

  /** Number `one` to what the others make. */
  private withOne(kind: SolidNode['kind'], all: Keyed[], one: number): Manifold {
    const { solid } = all[one]!, others = all.filter((_, i) => i !== one);
    const named = (what: string) => `${what}: ${others.map(({ key }) => key).join(' ')}`;
    if (kind === 'common') return this.keep(named('common'), () => this.whole('common', others)).intersect(solid);
    if (kind === 'cut' && one === 0) return solid.subtract(this.union(others));
    if (kind === 'cut') return this.keep(named('cut'), () => this.whole('cut', others)).subtract(solid);
    const rest = this.groups(all).flatMap((group) => (group.includes(all[one]!) ? group.filter((each) => each !== all[one]) : [{ key: '', solid: this.union(group) }]));
    return this.keep(named('join'), () => this.library.Manifold.union(rest.map((each) => each.solid))).add(solid);
  }

  /** Many in a few groups, which stay as they are when one of another group changes. */
  private groups(all: Keyed[]): Keyed[][] {
    const count = all.length < 6 ? all.length : Math.round(Math.sqrt(all.length));
    return Array.from({ length: count }, (_, i) => all.slice(Math.floor((i * all.length) / count), Math.floor(((i + 1) * all.length) / count)));
  }

  private union(of: Keyed[]): Manifold {
    if (of.length === 1) return of[0]!.solid;
    return this.keep(`join: ${of.map(({ key }) => key).join(' ')}`, () => this.library.Manifold.union(of.map(({ solid }) => solid)));
  }

  private keep(key: string, make: () => Manifold): Manifold {
    const kept = this.solids.get(key) ?? { solid: make(), round: this.round };
    kept.round = this.round;
    this.solids.set(key, kept);
    // The library works when it is asked for something, and then for good.
    kept.solid!.status();
    return kept.solid!;
  }

  /** Whose faces are the most. */
  private mainPart(solid: Manifold): number {
    let best = 0, most = -1;
    for (const run of this.runsOf(solid.getMesh())) {
      if (run.count > most) [best, most] = [run.part, run.count];
    }
    return best;
  }

  private runsOf(mesh: { runIndex: Uint32Array; runOriginalID: Uint32Array }): PartRun[] {
    const runs: PartRun[] = [];
    for (let i = 0; i < mesh.runOriginalID.length; i += 1) {
      const first = mesh.runIndex[i]! / 3, count = mesh.runIndex[i + 1]! / 3 - first;
      const part = this.owners.get(mesh.runOriginalID[i]!) ?? 0, last = runs[runs.length - 1];
      if (last && last.part === part && last.first + last.count === first) last.count += count;
      else if (count > 0) runs.push({ part, first, count });
    }
    return runs;
  }

  private meshOf(solid: Manifold): SolidMesh {
    const mesh = solid.getMesh();
    const stride = mesh.numProp, vertices = mesh.vertProperties.length / stride;
    const positions = new Float32Array(3 * vertices), uv = new Float32Array(2 * vertices);
    for (let v = 0; v < vertices; v += 1) {
      for (let k = 0; k < 3; k += 1) positions[3 * v + k] = mesh.vertProperties[stride * v + k]!;
      for (let k = 0; k < 2; k += 1) uv[2 * v + k] = stride >= 5 ? Math.min(1, Math.max(0, mesh.vertProperties[stride * v + 3 + k]!)) : 0;
    }
    const triangles = mesh.triVerts.slice();
    const mergeFrom = (mesh.mergeFromVert ?? new Uint32Array()).slice(), mergeTo = (mesh.mergeToVert ?? new Uint32Array()).slice();
    // The library counts as if all were one shell.
    const genus = solid.genus() + shellsOf({ vertices, triangles, mergeFrom, mergeTo }) - 1;
    return { positions, uv, triangles, mergeFrom, mergeTo, runs: this.runsOf(mesh), volume: solid.volume(), area: solid.surfaceArea(), genus };
  }

  /** Lets go of what was not asked for in a while. */
  private forget(): void {
    for (const map of [this.parts, this.solids]) {
      for (const [key, kept] of map) {
        if (kept.round + kKept > this.round) continue;
        kept.solid?.delete();
        kept.cavity?.delete();
        map.delete(key);
      }
    }
    for (const [key, mesh] of this.meshes) if (mesh.round + kKept <= this.round) this.meshes.delete(key);
  }

  /** Keys of the meshes that are here. */
  knownMeshes(): string[] {
    return [...this.meshes.keys()];
  }
}

function inWorld(m: number[], [x, y, z]: [number, number, number]): [number, number, number] {
  return [0, 1, 2].map((k) => m[k]! * x + m[4 + k]! * y + m[8 + k]! * z + m[12 + k]!) as [number, number, number];
}

function failureOf(thrown: unknown): SolidFailure {
  if (thrown instanceof Unsolvable) return thrown.failure;
  return { error: thrown instanceof RangeError ? 'OutOfMemory' : 'SolidFailed' };
}

/** How many closed surfaces there are that no edge joins; vertices that are merged are one. */
function shellsOf({ vertices, triangles, mergeFrom, mergeTo }: { vertices: number; triangles: Uint32Array; mergeFrom: Uint32Array; mergeTo: Uint32Array }): number {
  const root = new Uint32Array(vertices), used = new Uint8Array(vertices);
  for (let v = 0; v < vertices; v += 1) root[v] = v;
  const find = (v: number) => {
    while (root[v] !== v) v = root[v] = root[root[v]!]!;
    return v;
  };
  let shells = 0;
  const join = (a: number, b: number) => {
    const from = find(a), to = find(b);
    if (from === to) return;
    root[from] = to;
    shells -= 1;
  };
  const use = (v: number) => {
    shells += used[v] ? 0 : 1;
    used[v] = 1;
  };
  for (const v of triangles) use(v);
  for (let i = 0; i < mergeFrom.length; i += 1) {
    use(mergeFrom[i]!);
    use(mergeTo[i]!);
    join(mergeFrom[i]!, mergeTo[i]!);
  }
  for (let i = 0; i < triangles.length; i += 3) {
    join(triangles[i]!, triangles[i + 1]!);
    join(triangles[i]!, triangles[i + 2]!);
  }
  return shells;
}
