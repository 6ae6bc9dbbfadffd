// The solver of steps: parts in their places → solids, on manifold-3d. Every sub-result is kept under its key, so that
// an edited part is united again without redoing what did not change. Runs in a worker; knows no page.
import type { Manifold, ManifoldToplevel } from 'manifold-3d';
import { blamed } from './blame.ts';
import { Booleans } from './booleans.ts';
import { hollowOf } from './fields.ts';
import { clear, newScratch } from './kept.ts';
import type { Keyed, Kept, Made, Scratch } from './kept.ts';
import { isPart, isRound, isWorthKeeping, nodeKey } from './names.ts';
import { Operands } from './operands.ts';
import type { Tools } from './parts.ts';
import type { SolidFailure, SolidMesh, SolidNode, SolveRequest } from './protocol.ts';
import { Seams } from './seams.ts';
import type { SelfCrossing } from './self_crossing.ts';
import { meshOfFaces, meshOfSolid } from './solid_mesh.ts';
import { SolidStore } from './solid_store.ts';
import { isSpeck } from './specks.ts';
import { Unsolvable, failureOf } from './unsolvable.ts';

export interface Solved {
  node: SolidNode;
  ms: number;
  mesh?: SolidMesh;
  failure?: SolidFailure;
}

/** A solid of its own with what stays free in it, or faces. */
type Combined = Made & Pick<Kept, 'cavity' | 'free'>;

/** Whether a node is an operand of others, so that its solid is needed and not only its faces. */
function isOperandOf({ key }: SolidNode, nodes: SolidNode[]): boolean {
  return nodes.some(({ operands }) => operands.some((operand) => !isPart(operand) && operand.node === key));
}

export class SolidKernel {
  private readonly tools: Tools;
  private readonly store: SolidStore;
  private readonly operands: Operands;
  private readonly seams: Seams;
  private readonly booleans: Booleans;
  /** What was solved last. */
  private nodes: SolidNode[] = [];

  constructor(
    library: ManifoldToplevel,
    selfCrossing: SelfCrossing,
    private readonly now: () => number = () => performance.now(),
  ) {
    this.tools = { library, selfCrossing };
    this.store = new SolidStore(this.tools);
    this.operands = new Operands(this.tools, this.store);
    this.seams = new Seams(this.tools, this.store);
    this.booleans = new Booleans(this.tools, this.store);
  }

  /** How much is kept. */
  get counts(): SolidStore['counts'] {
    return this.store.counts;
  }

  keepMeshes(meshes: SolveRequest['meshes']): void {
    this.store.parts.keepMeshes(meshes);
  }

  /**
   * Solves what is wanted, one node after the other, and hands out each as it is done. Between two it can be given up,
   * and says what share is done.
   */
  *solve(request: SolveRequest, done: (solved: Solved) => void): Generator<number, void> {
    const { nodes, wanted } = request;
    this.store.begin(request);
    this.nodes = nodes;
    for (const [index, node] of nodes.entries()) {
      const started = this.now(),
        kept = this.keptOf(node, isOperandOf(node, nodes));
      if (wanted.includes(node.key)) done({ node, ...this.answerOf(kept), ms: this.now() - started });
      yield (index + 1) / nodes.length;
    }
    this.store.forget();
  }

  /** Makes what an edit of this part will count on, a piece at a time; null: of none. */
  *ahead(part: number | null): Generator<void, void> {
    this.store.dropAhead(part);
    const touched = new Set<string>();
    for (const node of part === null ? [] : this.nodes) {
      const changed = node.operands.map((operand) =>
        isPart(operand) ? operand.part === part : touched.has(operand.node),
      );
      if (changed.includes(true)) touched.add(node.key);
      if (isWorthKeeping(node.kind, changed) && this.operands.areHere(node))
        yield* this.makeAhead({ ...node, coarse: false }, changed, part!);
    }
  }

  /** Lets go of all that was kept. */
  forgetAll(): void {
    this.store.forgetAll();
  }

  /** What there is of a node, or what is made of it now. */
  private keptOf(node: SolidNode, isOperand: boolean): Kept {
    const key = nodeKey(node.key, node.coarse),
      known = this.store.get(key),
      isEnough = known && !(known.faces && isOperand),
      kept = isEnough ? known : this.make(node, isOperand);
    this.store.set(key, this.store.use(kept));
    return kept;
  }

  private answerOf({ solid, faces, failure }: Kept): Pick<Solved, 'mesh' | 'failure'> {
    const { sources } = this.store.parts;
    try {
      if (faces) return { mesh: meshOfFaces(faces, sources) };
      if (solid) return { mesh: meshOfSolid(solid, sources) };
      return failure ? { failure } : {};
    } catch (thrown) {
      return { failure: failureOf(thrown) };
    }
  }

  private make(node: SolidNode, isOperand: boolean): Kept {
    const scratch = newScratch(),
      { ids, from } = scratch,
      { round } = this.store.parts;
    let all: Keyed[] = [];
    try {
      all = this.operands.of(node, scratch);
      const made =
        node.kind === 'hollow' ? this.hollow(node, all, scratch) : this.combine(node, all, scratch, isOperand);
      if ('faces' in made) return { solid: null, faces: made.faces, round, ids, from };
      const error = this.errorOf(made.solid, node, all);
      if (error) {
        scratch.own.push(made.solid, ...(made.cavity ? [made.cavity] : []));
        throw new Unsolvable({ error });
      }
      return { ...made, round, ids, from };
    } catch (thrown) {
      const partOf = (solid: Manifold) => this.store.parts.registerLike(solid, ids).part;
      return {
        solid: null,
        failure: blamed(this.tools.library, failureOf(thrown), node.kind, all, partOf),
        round,
        ids,
      };
    } finally {
      clear(scratch);
    }
  }

  /** Why what was made is no solid; null where it is one. */
  private errorOf(solid: Manifold, { kind }: SolidNode, [first]: Keyed[]): SolidFailure['error'] | null {
    if (solid.status() !== 'NoError') return 'SolidFailed';
    if (solid.isEmpty()) return 'SolidEmpty';
    if (kind === 'join') return null;
    // What is left of the operands may be as thin as rounding.
    const { min, max } = first!.solid().boundingBox(),
      diagonal = Math.hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
    return isSpeck({ volume: solid.volume(), area: solid.surfaceArea() }, diagonal) ? 'SolidEmpty' : null;
  }

  private hollow(node: SolidNode, operands: Keyed[], scratch: Scratch): Combined {
    const { library } = this.tools,
      { own, ids } = scratch;
    let body = operands[0]!.solid();
    // A part with live symmetry comes with its twin.
    if (operands.length > 1) own.push((body = library.Manifold.union(operands.map(({ solid }) => solid()))));
    const { shell, cavity } = hollowOf(library, body, node, { ...this.store.parts.registerLike(body, ids), own });
    return { solid: shell, cavity, free: [cavity] };
  }

  private combine(node: SolidNode, operands: Keyed[], scratch: Scratch, isOperand: boolean): Combined {
    const free = node.kind === 'join' ? this.operands.insides(node) : [],
      all = [...operands, ...this.seams.of(node, operands, scratch)],
      isCutInTheEnd = isRound(node) && free.length > 0,
      made = this.booleans.combine(node, all, scratch, isOperand || isCutInTheEnd);
    if ('faces' in made || free.length === 0) return made;
    if (!isCutInTheEnd) return { ...made, free };
    scratch.own.push(made.solid);
    return { solid: this.tools.library.Manifold.difference([made.solid, ...free]), free };
  }

  private *makeAhead(node: SolidNode, changed: boolean[], part: number): Generator<void, void> {
    const scratch = newScratch(),
      before = this.store.keys();
    try {
      const operands = this.operands.of(node, scratch),
        seams = this.seams.of(node, operands, scratch),
        isChanged = (operand: Keyed) => changed[operands.indexOf(operand)] === true;
      yield* this.booleans.prepare({
        kind: node.kind,
        all: [...operands, ...seams],
        changed: [...changed, ...seams.map(({ of }) => of!.some(isChanged))],
      });
    } catch (thrown) {
      // The edit says so itself.
      failureOf(thrown);
    } finally {
      this.store.markAhead(before, part);
      clear(scratch);
    }
  }
}
