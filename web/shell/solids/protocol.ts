// What the page and the worker of solids tell each other. Positions are in the world's units (the longer
// side of a picture is 1), matrices are 4 × 4 in columns.
import type { LifeMessage } from '../live_worker.ts';

/** A closed mesh, as the engine has it; uv may be empty. */
export interface MeshData {
  positions: Float32Array;
  uv: Float32Array;
  triangles: Uint32Array;
}

/** A mesh in its place; `part` says whose faces they are. */
export interface PartOperand {
  mesh: string;
  part: number;
  matrix: number[];
}
export interface NodeOperand {
  node: string;
}
export type SolidOperand = PartOperand | NodeOperand;

export type SolidKind = 'join' | 'cut' | 'common' | 'hollow';

/** One step to solve. Equal keys, equal solids. */
export interface SolidNode {
  key: string;
  step: number;
  kind: SolidKind;
  operands: SolidOperand[];
  /** Radius at the seams; 0: sharp. */
  blend: number;
  wall: number;
  /** Unit direction in which a hollow is open; null: it is closed. */
  opening: [number, number, number] | null;
  /** Share of the length that way that is cut off. */
  cut: number;
  /** For a preview: half as fine where fineness costs time. */
  coarse: boolean;
}

export interface SolveRequest {
  id: number;
  /** In an order in which operands come first. */
  nodes: SolidNode[];
  /** Keys of the nodes whose meshes are wanted. */
  wanted: string[];
  /** Meshes that this worker has not been given yet, by key. */
  meshes: Record<string, MeshData>;
}

/** The part that is likely to be edited next; null: none. */
export interface ExpectRequest {
  expect: number | null;
}

/** Faces [first, first + count) come from this part. */
export interface PartRun {
  part: number;
  first: number;
  count: number;
}

export interface SolidMesh extends MeshData {
  /** Vertices at one place with different uv: `from[i]` stands where `to[i]` does. */
  mergeFrom: Uint32Array;
  mergeTo: Uint32Array;
  runs: PartRun[];
  volume: number;
  area: number;
  /** Handles, over all shells. */
  genus: number;
}

/** Why a solid could not be made; codes of the engine's errors. */
export interface SolidFailure {
  error: 'SolidEmpty' | 'WallTooThick' | 'PartCrossesItself' | 'SolidFailed' | 'OutOfMemory';
  /** The part at fault, where one is. */
  part?: number;
  /** Where it shows, world. */
  at?: [number, number, number];
  /** Of a wall that is too thick: the thickest that fits, world; 0: none does. */
  thickest?: number;
}

export type WorkerMessage =
  | LifeMessage
  | { type: 'progress'; id: number; done: number }
  | {
      type: 'solid';
      id: number;
      step: number;
      key: string;
      coarse: boolean;
      ms: number;
      mesh?: SolidMesh;
      failure?: SolidFailure;
    }
  /** `bytes`: what the library's memory has grown to. */
  | { type: 'done'; id: number; bytes: number };
