// What the solver of solids keeps, and what it has in hand while it makes something.
import type { Manifold } from 'manifold-3d';
import type { Faces } from './flaps.ts';
import type { Near } from './near.ts';
import type { SolidFailure, SolidOperand } from './protocol.ts';

/** A part or a solid that was made, or why it could not be. */
export interface Kept {
  solid: Manifold | null;
  /** In its stead, for a solid that no other is made of. */
  faces?: Faces;
  /** What is near the parts with which it is to be joined; null: that is no quicker than all of it. */
  near?: Near | null;
  /** What was scooped out of it. */
  cavity?: Manifold;
  /** That, and what was scooped out of what it is joined from: it stays free. */
  free?: Manifold[];
  failure?: SolidFailure;
  /** The request that last asked for it. */
  round: number;
  /** What it was made from, which is kept as long: its faces are asked for. */
  from?: Kept[];
  /** Original ids of its own. */
  ids?: number[];
  /** The part for whose edit it was made, before one needed it. */
  ahead?: number | false;
  /** Of a union, the keys of what it was made of. */
  joined?: string[];
}

/** What is made on the way to a solid. */
export interface Scratch {
  /** Deleted when the step is done. */
  own: Manifold[];
  ids: number[];
  from: Kept[];
}

export const newScratch = (): Scratch => ({ own: [], ids: [], from: [] });

export function clear({ own }: Scratch): void {
  for (const solid of own.splice(0)) solid.delete();
}

/** An operand in its place. */
export interface Keyed {
  operand: SolidOperand;
  key: string;
  /** Made when it is first needed. */
  solid(): Manifold;
  from: Kept;
  /** Of a rounding, whose seam it is. */
  of?: Keyed[];
}

/** What was made of a step's operands: a solid, or its faces alone. */
export type Made = { solid: Manifold } | { faces: Faces };
