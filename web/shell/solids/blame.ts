// Which part a step fails at that names none.
import type { Manifold, ManifoldToplevel } from 'manifold-3d';
import type { Keyed } from './kept.ts';
import type { SolidFailure, SolidNode } from './protocol.ts';
import { failureOf } from './unsolvable.ts';

function isSound(make: () => Manifold): boolean {
  try {
    const solid = make(),
      sound = solid.status() === 'NoError';
    solid.delete();
    return sound;
  } catch (thrown) {
    failureOf(thrown);
    return false;
  }
}

/** The first operand with which the step does not go, of those before it; where it goes with all, the first of all. */
function culpritOf(library: ManifoldToplevel, kind: SolidNode['kind'], all: Keyed[]): Keyed | undefined {
  const { Manifold } = library,
    combine = { join: Manifold.union, hollow: Manifold.union, cut: Manifold.difference, common: Manifold.intersection }[
      kind
    ];
  return all.find((_, i) => !isSound(() => combine(all.slice(0, i + 1).map(({ solid }) => solid())))) ?? all[0];
}

/** The failure with the part that it is about, and the middle of it; `partOf` names the part that most of a solid is from. */
export function blamed(
  library: ManifoldToplevel,
  failure: SolidFailure,
  kind: SolidNode['kind'],
  all: Keyed[],
  partOf: (solid: Manifold) => number,
): SolidFailure {
  if (failure.error !== 'SolidFailed' || failure.part !== undefined) return failure;
  try {
    const culprit = culpritOf(library, kind, all);
    if (!culprit) return failure;
    const solid = culprit.solid(),
      { min, max } = solid.boundingBox();
    return {
      ...failure,
      part: partOf(solid),
      at: [0, 1, 2].map((k) => (min[k]! + max[k]!) / 2) as [number, number, number],
    };
  } catch (thrown) {
    // Nothing can be asked of it.
    failureOf(thrown);
    return failure;
  }
}
