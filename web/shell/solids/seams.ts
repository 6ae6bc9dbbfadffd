// What rounds the seams of a step, kept seam by seam: an edit of a part rounds the seams of that part alone.
import type { Manifold } from 'manifold-3d';
import { seamOf } from './fields.ts';
import type { Keyed, Kept, Scratch } from './kept.ts';
import { isRound, pairsOf, seamKey } from './names.ts';
import type { Tools } from './parts.ts';
import type { SolidNode } from './protocol.ts';
import type { SolidStore } from './solid_store.ts';

export class Seams {
  constructor(
    private readonly tools: Tools,
    private readonly store: SolidStore,
  ) {}

  /** A rounding for every two operands that meet; none for a step with sharp seams. */
  of(node: SolidNode, operands: Keyed[], scratch: Scratch): Keyed[] {
    if (!isRound(node)) return [];
    return pairsOf(node.kind, operands).flatMap(([one, other]) => {
      // A preview has the fine one, too, where it is there.
      const fine = seamKey({ ...node, coarse: false }, one, other),
        key = this.store.has(fine) ? fine : seamKey(node, one, other),
        kept = this.store.get(key) ?? this.made(node, one, other);
      this.store.set(key, kept);
      scratch.from.push(this.store.use(kept));
      const { solid } = kept;
      return solid ? [{ operand: { node: key }, key, solid: () => solid, from: kept, of: [one, other] }] : [];
    });
  }

  private made(node: SolidNode, one: Keyed, other: Keyed): Kept {
    const ids: number[] = [],
      own: Manifold[] = [],
      { parts } = this.store;
    try {
      const seam = {
        one: one.solid(),
        other: other.solid(),
        node,
        idOf: (operand: Manifold) => parts.registerLike(operand, ids).id,
      };
      return { solid: seamOf(this.tools.library, seam, own), ids, round: parts.round };
    } finally {
      for (const solid of own) solid.delete();
    }
  }
}
