// What the solver of solids keeps, and what it has in hand while it makes something.
import type { Manifold } from 'manifold-3d';
import type { Faces } from './flaps.ts';
import { keysOf } from './names.ts';
import type { Near } from './near.ts';
import type { MeshData, SolidFailure, SolidOperand } from './protocol.ts';

/** A part or a solid that was made, or why it could not be. */
export interface Kept {
  solid: Manifold | null;
  /** In its stead, for a solid that no other is made of. */
  faces?: Faces;
  /** What is near the parts with which it is to be joined. */
  near?: Near | null;
  /** What was scooped out of it. */
  cavity?: Manifold;
  /** That, and what was scooped out of what it is joined from: it stays free. */
  free?: Manifold[];
  failure?: SolidFailure;
  round: number;
  /** What it was made from, which is kept as long: its faces are asked for. */
  from?: Kept[];
  /** Original ids of its own. */
  ids?: number[];
  /** The part for whose edit it was made, before one needed it. */
  ahead?: number | false;
  /** Of a union, the keys of what it was made of. */
  joined?: string[];
  /** It is made for what is likely alone: nobody has asked for it. */
  likely?: boolean;
  /** Of a plain union the name of what it is made of, as names.ts has it. */
  name?: string;
  /** Of a part that was looked over elsewhere: what it is made from when it is needed, and the original id of its faces. */
  waiting?: { mesh: MeshData; id: number };
}

/** What is made on the way to a solid. */
export interface Bench {
  /** Deleted when the step is done. */
  own: Manifold[];
  ids: number[];
  from: Kept[];
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

/** Unions of some of these that are there, and what is left. */
export function madeOf(kept: Iterable<Kept>, all: Keyed[]): { made: Keyed[][]; left: Keyed[] } {
  const made: Keyed[][] = [],
    unions = [...kept].flatMap(({ joined }) => (joined ? [joined] : []));
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
