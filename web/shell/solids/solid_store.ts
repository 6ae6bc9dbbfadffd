// What the solver has made, by keys: an LRU cache whose age is counted in requests. What a solid was made from is kept
// as long as the solid.
import type { Manifold } from 'manifold-3d';
import type { Keyed, Kept } from './kept.ts';
import { isPart, keysOf } from './names.ts';
import { PartStore } from './part_store.ts';
import type { Tools } from './parts.ts';
import type { SolveRequest } from './protocol.ts';

/** Unions that are there of some operands, and the operands that are left. */
export interface Found {
  made: Keyed[][];
  left: Keyed[];
}

export class SolidStore {
  readonly parts: PartStore;
  private readonly solids = new Map<string, Kept>();

  constructor(tools: Tools) {
    this.parts = new PartStore(tools);
  }

  /** How much is kept. */
  get counts(): { solids: number; parts: number; meshes: number; sources: number } {
    return { solids: this.solids.size, ...this.parts.counts };
  }

  /** Another request: what it names is kept for some more of them. */
  begin({ nodes, meshes }: Pick<SolveRequest, 'nodes' | 'meshes'>): void {
    this.parts.round += 1;
    this.parts.keepMeshes(meshes);
    for (const operand of nodes.flatMap((node) => node.operands)) if (isPart(operand)) this.parts.touch(operand.mesh);
  }

  get(key: string): Kept | undefined {
    return this.solids.get(key);
  }

  has(key: string): boolean {
    return this.solids.has(key);
  }

  keys(): Set<string> {
    return new Set(this.solids.keys());
  }

  /** Keeps a solid under this key, and lets go of another one that was there. */
  set(key: string, kept: Kept): void {
    const before = this.solids.get(key);
    this.solids.set(key, kept);
    if (before && before !== kept) this.letGo(before);
  }

  /** Keeps what was asked for, and what it was made from. */
  use(kept: Kept): Kept {
    const { round } = this.parts;
    if (kept.round !== round) {
      kept.round = round;
      kept.from?.forEach((each) => this.use(each));
    }
    return kept;
  }

  /** What some of a step's operands make, made where it is not there; `joined`: of a union, the keys of these. */
  keep(key: string, of: Keyed[], make: () => Manifold, joined?: string[]): Manifold {
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

  /** The largest unions that are there of some of these. */
  unionsOf(all: Keyed[]): Found {
    const unions = [...this.solids.values()].flatMap(({ joined }) => (joined ? [joined] : [])),
      made: Keyed[][] = [];
    for (let left = all; ;) {
      const keys = new Set(keysOf(left));
      let most: string[] = [];
      for (const joined of unions)
        if (joined.length > Math.max(1, most.length) && joined.every((key) => keys.has(key))) most = joined;
      if (most.length === 0) return { made, left };
      const taken = new Set(most);
      made.push(left.filter(({ key }) => taken.has(key)));
      left = left.filter(({ key }) => !taken.has(key));
    }
  }

  drop(key: string): void {
    const kept = this.solids.get(key);
    this.solids.delete(key);
    if (kept) this.letGo(kept);
  }

  /** What is there but was not before is made ahead for the edit of a part. */
  markAhead(before: ReadonlySet<string>, part: number): void {
    for (const [key, kept] of this.solids) if (!before.has(key)) kept.ahead = part;
  }

  /** Lets go of what was made ahead for other parts and never needed. */
  dropAhead(part: number | null): void {
    for (const [key, kept] of this.solids) if (kept.ahead && kept.ahead !== part) this.drop(key);
  }

  /** Lets go of what was not asked for in a while. */
  forget(): void {
    this.parts.forget((kept) => this.letGo(kept));
    for (const [key, kept] of this.solids) if (this.parts.isOld(kept)) this.drop(key);
  }

  forgetAll(): void {
    this.parts.age();
    this.forget();
  }

  private letGo(kept: Kept): void {
    for (const solid of [kept.solid, kept.cavity, kept.near?.solid]) solid?.delete();
    this.parts.unregister(kept.ids ?? []);
  }
}
