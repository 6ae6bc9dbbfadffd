// What a step is made of: parts and earlier solids in their places.
import type { Manifold } from 'manifold-3d';
import { mappedPlace } from './affine.ts';
import type { Keyed, Scratch } from './kept.ts';
import { isPart, keysOf, nodeKey } from './names.ts';
import type { Tools } from './parts.ts';
import type { PartOperand, SolidNode, SolidOperand } from './protocol.ts';
import type { SolidStore } from './solid_store.ts';
import { Unsolvable } from './unsolvable.ts';

/** A solid that is made when it is first asked for, and deleted with the scratch. */
function once({ own }: Scratch, make: () => Manifold): () => Manifold {
  let made: Manifold | null = null;
  return () => {
    if (!made) own.push((made = make()));
    return made;
  };
}

export class Operands {
  constructor(
    private readonly tools: Tools,
    private readonly store: SolidStore,
  ) {}

  /**
   * The operands of a step. Where it only sticks them together, each is without the insides of the others beforehand:
   * that cuts a handle, while cutting all of it in the end would go along the whole inside of the mug.
   */
  of(node: SolidNode, scratch: Scratch): Keyed[] {
    const all = node.operands.map((operand) => this.one(operand, node.coarse, scratch));
    if (node.kind !== 'join' || node.blend > 0) return all;
    const insides = node.operands.map((operand) => this.insidesOf(operand, node.coarse));
    return all.map((each, i) => {
      const free = insides.flatMap((inside, k) => (k === i ? [] : inside)),
        beside = all.filter((_, k) => k !== i && insides[k]!.length > 0);
      if (free.length === 0) return each;
      const cut = () => this.tools.library.Manifold.difference([each.solid(), ...free]);
      return { ...each, key: `${each.key} beside ${keysOf(beside).join(' ')}`, solid: once(scratch, cut) };
    });
  }

  /** The insides of a step's hollow operands: the end of a handle does not stand into its mug. */
  insides({ operands, coarse }: SolidNode): Manifold[] {
    return operands.flatMap((operand) => this.insidesOf(operand, coarse));
  }

  /** Whether all operands were made before and are still there. */
  areHere({ operands }: SolidNode): boolean {
    return operands.every((operand) => {
      const kept = isPart(operand) ? this.store.parts.known(operand) : this.store.get(operand.node);
      return !!kept?.solid;
    });
  }

  private insidesOf(operand: SolidOperand, coarse: boolean): Manifold[] {
    return isPart(operand) ? [] : (this.store.get(nodeKey(operand.node, coarse))?.free ?? []);
  }

  private one(operand: SolidOperand, coarse: boolean, scratch: Scratch): Keyed {
    if (isPart(operand)) return this.part(operand, coarse, scratch);
    const key = nodeKey(operand.node, coarse),
      kept = this.store.get(key),
      solid = kept?.solid;
    if (!solid) throw new Unsolvable(kept?.failure ?? { error: 'SolidFailed' });
    scratch.from.push(this.store.use(kept));
    return { operand, key, solid: () => solid, from: kept };
  }

  private part(operand: PartOperand, coarse: boolean, scratch: Scratch): Keyed {
    const { parts } = this.store,
      kept = parts.of(operand, coarse),
      { solid, failure } = kept;
    scratch.from.push(this.store.use(kept));
    if (!solid)
      throw new Unsolvable({ ...failure!, ...(failure!.at ? { at: mappedPlace(operand.matrix, failure!.at) } : {}) });
    const place = () => solid.transform(operand.matrix as Parameters<Manifold['transform']>[0]);
    return { operand, key: parts.nameOf(operand), solid: once(scratch, place), from: kept };
  }
}
