// Parts as the solver of steps has them: their meshes, the solids made of them, each kept under its key for as long as
// it is asked for, and what the faces of all solids were.
import type { Manifold } from 'manifold-3d';
import type { Kept } from './kept.ts';
import { partKey } from './names.ts';
import { fitPaint } from './paint.ts';
import { FaultyPart, fromMesh, importPart } from './parts.ts';
import type { Tools } from './parts.ts';
import type { MeshData, PartOperand, SolveRequest } from './protocol.ts';
import { carried, runsOf } from './sources.ts';
import type { Source, Sources } from './sources.ts';
import { failureOf } from './unsolvable.ts';

/** How many requests long a sub-result is kept that nobody asks for. */
const kKept = 12;

export class PartStore {
  private readonly meshes = new Map<string, { data: MeshData; round: number }>();
  private readonly parts = new Map<string, Kept>();
  private readonly registered = new Map<number, Source>();
  /** Counts the requests. */
  round = 0;

  constructor(private readonly tools: Tools) {}

  /** What faces were, by original ids of manifold-3d. */
  get sources(): Sources {
    return this.registered;
  }

  /** How many are kept. */
  get counts(): { parts: number; meshes: number; sources: number } {
    return { parts: this.parts.size, meshes: this.meshes.size, sources: this.registered.size };
  }

  keepMeshes(meshes: SolveRequest['meshes']): void {
    for (const [key, data] of Object.entries(meshes)) this.meshes.set(key, { data, round: this.round });
  }

  /** Keeps the mesh of this key for some more requests. */
  touch(key: string): void {
    const mesh = this.meshes.get(key);
    if (mesh) mesh.round = this.round;
  }

  meshOf(key: string): MeshData | undefined {
    return this.meshes.get(key)?.data;
  }

  /** What there is of a part that was looked over. */
  known(operand: PartOperand): Kept | undefined {
    return this.parts.get(partKey(operand));
  }

  /** The part as a solid, or why it is none. Coarse parts, those of a gesture, are not tested for self-intersection. */
  of(operand: PartOperand, coarse: boolean): Kept {
    const key = partKey(operand),
      known = this.parts.get(key),
      loose = this.parts.get(`${key}~`);
    if (known) return known;
    const mesh = this.meshOf(operand.mesh);
    if (loose && (coarse || (mesh && !this.tools.selfCrossing(mesh)))) {
      if (coarse) return loose;
      // Now it has been looked over.
      this.parts.delete(`${key}~`);
      this.parts.set(key, loose);
      return loose;
    }
    const kept = this.imported(operand, coarse);
    this.parts.set(coarse ? `${key}~` : key, kept);
    return kept;
  }

  /** Equal names, equal operands. What was not looked over is another thing than what was. */
  nameOf(operand: PartOperand): string {
    return `${partKey(operand)}${this.known(operand) ? '' : '~'}@${operand.matrix.join()}`;
  }

  /** An original id for faces from this source. */
  register(source: Source, ids: number[]): number {
    const id = this.tools.library.Manifold.reserveIDs(1);
    this.registered.set(id, source);
    ids.push(id);
    return id;
  }

  /** An original id for new faces that look as a solid does, and the part that most of it is from. */
  registerLike(solid: Manifold, ids: number[]): { id: number; part: number } {
    const mesh = solid.getMesh(),
      { positions, uv } = carried(mesh, this.registered),
      runs = runsOf(mesh, this.registered),
      { part } = runs.reduce((most, run) => (run.count > most.count ? run : most), { part: 0, count: -1 });
    return { id: this.register({ part, paint: fitPaint(positions, uv) }, ids), part };
  }

  /** Whether nobody has asked for it in a while. */
  isOld({ round }: { round: number }): boolean {
    return round + kKept <= this.round;
  }

  /** Makes all that is kept old. */
  age(): void {
    this.round += kKept;
  }

  /** Lets go of what is old. */
  forget(letGo: (kept: Kept) => void): void {
    for (const [key, kept] of this.parts) {
      if (!this.isOld(kept)) continue;
      this.parts.delete(key);
      letGo(kept);
    }
    for (const [key, mesh] of this.meshes) if (this.isOld(mesh)) this.meshes.delete(key);
  }

  /** Faces from these sources are asked for no more. */
  unregister(ids: number[]): void {
    for (const id of ids) this.registered.delete(id);
  }

  private imported({ mesh: key, part }: PartOperand, unchecked: boolean): Kept {
    const mesh = this.meshOf(key),
      { round } = this,
      ids: number[] = [];
    if (!mesh) return { solid: null, failure: { error: 'SolidFailed', part }, round };
    const register = (piece: MeshData) => this.register({ part, mesh: piece }, ids);
    try {
      return {
        solid: unchecked ? fromMesh(this.tools.library, mesh, register) : importPart(this.tools, mesh, register),
        round,
        ids,
      };
    } catch (thrown) {
      const failure =
        thrown instanceof FaultyPart ? { error: 'PartCrossesItself' as const, at: thrown.at } : failureOf(thrown);
      return { solid: null, failure: { ...failure, part }, round, ids };
    }
  }
}
