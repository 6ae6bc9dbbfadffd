// The mesh of a solid as the page gets it: whose its faces are, what they look like, how large it is.
import type { Manifold } from 'manifold-3d';
import { withoutFlaps } from './flaps.ts';
import type { Faces } from './flaps.ts';
import type { SolidMesh } from './protocol.ts';
import { sizeOf } from './sizes.ts';
import { carried, runsOf } from './sources.ts';
import type { Sources } from './sources.ts';
import { withoutSpecks } from './specks.ts';
import { countOf } from './topology.ts';

interface Size {
  volume: number;
  area: number;
}

const count = ({ vertProperties, triVerts }: Faces) => countOf(vertProperties.length / 3, triVerts);

function meshOf(whole: Faces, size: Size, sources: Sources): SolidMesh {
  const { pieces, handles } = count(whole),
    sound = withoutFlaps(whole),
    mesh = pieces > 1 ? withoutSpecks(sound) : sound;
  return {
    ...carried(mesh, sources),
    runs: runsOf(mesh, sources),
    ...size,
    genus: mesh === sound ? handles : count(mesh).handles,
  };
}

export function meshOfFaces(faces: Faces, sources: Sources): SolidMesh {
  return meshOf(faces, sizeOf(faces), sources);
}

export function meshOfSolid(solid: Manifold, sources: Sources): SolidMesh {
  return meshOf(solid.getMesh(), { volume: solid.volume(), area: solid.surfaceArea() }, sources);
}
