// Numbers at the points of a grid in space, and the surface where they change their sign.

export type Point = [number, number, number];

export interface Box {
  min: Point;
  max: Point;
}

export interface Grid {
  min: Point;
  step: number;
  /** Points along x, y and z; the one at (x, y, z) has number x + nx · (y + ny · z). */
  size: Point;
}

export function gridOver(box: Box, step: number): Grid {
  const size = [0, 1, 2].map((k) => Math.max(2, Math.ceil((box.max[k]! - box.min[k]!) / step) + 1)) as Point;
  return { min: [...box.min], step, size };
}

export function isWithin([nx, ny, nz]: Point, x: number, y: number, z: number): boolean {
  return x >= 0 && y >= 0 && z >= 0 && x < nx && y < ny && z < nz;
}

/** Interpolated between the grid's points; outside the grid the value at its rim. */
export function at(
  { min, step, size: [nx, ny, nz] }: Grid,
  values: Float32Array,
  x: number,
  y: number,
  z: number,
): number {
  const gx = Math.min(nx - 1.000001, Math.max(0, (x - min[0]) / step)),
    gy = Math.min(ny - 1.000001, Math.max(0, (y - min[1]) / step));
  const gz = Math.min(nz - 1.000001, Math.max(0, (z - min[2]) / step));
  const ix = gx | 0,
    iy = gy | 0,
    iz = gz | 0,
    fx = gx - ix,
    fy = gy - iy,
    fz = gz - iz;
  const i = ix + nx * (iy + ny * iz),
    up = nx * ny;
  const low =
    (values[i]! * (1 - fx) + values[i + 1]! * fx) * (1 - fy) +
    (values[i + nx]! * (1 - fx) + values[i + nx + 1]! * fx) * fy;
  const high =
    (values[i + up]! * (1 - fx) + values[i + up + 1]! * fx) * (1 - fy) +
    (values[i + up + nx]! * (1 - fx) + values[i + up + nx + 1]! * fx) * fy;
  return low * (1 - fz) + high * fz;
}

/** Calls for every point of the grid with its place, and keeps what it says. */
export function sample(
  { min, step, size: [nx, ny, nz] }: Grid,
  value: (x: number, y: number, z: number, index: number) => number,
): Float32Array {
  const values = new Float32Array(nx * ny * nz);
  for (let z = 0, i = 0; z < nz; z += 1) {
    for (let y = 0; y < ny; y += 1) {
      for (let x = 0; x < nx; x += 1, i += 1)
        values[i] = value(min[0] + x * step, min[1] + y * step, min[2] + z * step, i);
    }
  }
  return values;
}

/** Where the lowest number stands. */
export function lowestOf({ min, step, size: [nx, ny] }: Grid, values: Float32Array): Point {
  let lowest = 0;
  for (let i = 1; i < values.length; i += 1) if (values[i]! < values[lowest]!) lowest = i;
  return [
    min[0] + step * (lowest % nx),
    min[1] + step * (Math.floor(lowest / nx) % ny),
    min[2] + step * Math.floor(lowest / (nx * ny)),
  ];
}

/**
 * For each of the 256 ways in which the corners of a cell are inside or not: the triangles, as triples of the cell's
 * edges (4 · axis + which of the four). Corner c lies at (c & 1, c >> 1 & 1, c >> 2). On every face a line is drawn
 * round each run of corners that are inside; the lines of all faces close to loops, whatever the corners are, and
 * the neighbour sees the same lines the other way round: so the surface is closed (marching cubes).
 */
function makeCells(): number[][] {
  const edgeOf = (c: number, d: number) => {
    const axis = (c ^ d) >> 1,
      low = Math.min(c, d);
    return 4 * axis + (axis === 0 ? low >> 1 : axis === 1 ? (low & 1) + 2 * (low >> 2) : low);
  };
  // Corners of each face, counter-clockwise as seen from outside of the cell.
  const faces = [
    [0, 4, 6, 2],
    [1, 3, 7, 5],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 2, 3, 1],
    [4, 5, 7, 6],
  ];
  const corners = [0, 1, 2, 3, 4, 5, 6, 7],
    ends = corners.flatMap((c) =>
      corners.filter((d) => d > c && [1, 2, 4].includes(d ^ c)).map((d) => ({ edge: edgeOf(c, d), c, d })),
    );
  /** The faces that an edge is of, a bit each. */
  const facesOf = (edge: number) => {
    const { c, d } = ends.find((each) => each.edge === edge)!;
    return faces.reduce((bits, face, i) => bits | (face.includes(c) && face.includes(d) ? 1 << i : 0), 0);
  };
  const isAcross = (i: number, k: number, n: number) => i !== k && (i + 1) % n !== k && (k + 1) % n !== i;
  return Array.from({ length: 256 }, (_, mask) => {
    const isIn = (corner: number) => (mask >> corner) & 1;
    const next = new Map<number, number>();
    for (const face of faces) {
      for (let k = 0; k < 4; k += 1) {
        if (isIn(face[k]!) || !isIn(face[(k + 1) % 4]!)) continue;
        let end = k + 1;
        while (isIn(face[(end + 1) % 4]!)) end += 1;
        next.set(edgeOf(face[k]!, face[(k + 1) % 4]!), edgeOf(face[end % 4]!, face[(end + 1) % 4]!));
      }
    }
    const triangles: number[] = [];
    while (next.size > 0) {
      const loop: number[] = [];
      for (let edge = next.keys().next().value!; next.has(edge);) {
        loop.push(edge);
        const to = next.get(edge)!;
        next.delete(edge);
        edge = to;
      }
      // From a corner whose lines to the others go through the cell: one that lay in a face could cross the neighbour's.
      const first = loop.findIndex(
        (from, i) => !loop.some((to, k) => isAcross(i, k, loop.length) && facesOf(from) & facesOf(to)),
      );
      const turned = [...loop.slice(first), ...loop.slice(0, first)];
      for (let i = 1; i + 1 < turned.length; i += 1) triangles.push(turned[0]!, turned[i]!, turned[i + 1]!);
    }
    return triangles;
  });
}

const kCells = makeCells();

export interface Surface {
  positions: Float32Array;
  triangles: Uint32Array;
}

/** Above 0: a closed surface looks outward. */
export function signedVolume({ positions: p, triangles }: Surface): number {
  let volume = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t]!,
      b = 3 * triangles[t + 1]!,
      c = 3 * triangles[t + 2]!;
    volume +=
      p[a]! * (p[b + 1]! * p[c + 2]! - p[b + 2]! * p[c + 1]!) -
      p[a + 1]! * (p[b]! * p[c + 2]! - p[b + 2]! * p[c]!) +
      p[a + 2]! * (p[b]! * p[c + 1]! - p[b + 1]! * p[c]!);
  }
  return volume / 6;
}

/** The closed surface of where values are above 0, outward. What is inside at the rim of the grid is cut off there. */
export function surfaceWhere({ min, step, size: [nx, ny, nz] }: Grid, values: Float32Array): Surface {
  const up = nx * ny,
    offsets = [0, 1, nx, nx + 1, up, up + 1, up + nx, up + nx + 1];
  const isRim = (x: number, y: number, z: number) =>
    x === 0 || y === 0 || z === 0 || x === nx - 1 || y === ny - 1 || z === nz - 1;
  const value = (i: number) =>
    values[i]! > 0 && isRim(i % nx, Math.floor(i / nx) % ny, Math.floor(i / up)) ? -0.5 * step : values[i]!;
  const inside = new Uint8Array(values.length);
  for (let z = 1; z + 1 < nz; z += 1) {
    for (let y = 1; y + 1 < ny; y += 1) {
      for (let x = 1, i = 1 + nx * (y + ny * z); x + 1 < nx; x += 1, i += 1) inside[i] = values[i]! > 0 ? 1 : 0;
    }
  }
  const vertexOn = [0, 1, 2].map(() => new Int32Array(values.length).fill(-1));
  const positions: number[] = [],
    triangles: number[] = [];
  const strides = [1, nx, up];
  const corner = [0, 0, 0];
  const vertex = (cell: number, edge: number): number => {
    const axis = edge >> 2,
      which = edge & 3;
    const low = axis === 0 ? 2 * which : axis === 1 ? (which & 1) + 4 * (which >> 1) : which;
    const i = cell + offsets[low]!,
      known = vertexOn[axis]![i]!;
    if (known >= 0) return known;
    const a = value(i),
      b = value(i + strides[axis]!);
    // Never at a corner, where vertices of several edges would fall into one.
    const t = Math.min(0.999, Math.max(0.001, a / (a - b)));
    corner[0] = i % nx;
    corner[1] = Math.floor(i / nx) % ny;
    corner[2] = Math.floor(i / up);
    corner[axis]! += t;
    const made = positions.length / 3;
    positions.push(min[0] + step * corner[0]!, min[1] + step * corner[1]!, min[2] + step * corner[2]!);
    vertexOn[axis]![i] = made;
    return made;
  };
  for (let z = 0; z + 1 < nz; z += 1) {
    for (let y = 0; y + 1 < ny; y += 1) {
      for (let x = 0, i = nx * (y + ny * z); x + 1 < nx; x += 1, i += 1) {
        let mask = 0;
        for (let c = 0; c < 8; c += 1) mask |= inside[i + offsets[c]!]! << c;
        if (mask === 0 || mask === 255) continue;
        for (const edge of kCells[mask]!) triangles.push(vertex(i, edge));
      }
    }
  }
  return { positions: Float32Array.from(positions), triangles: Uint32Array.from(triangles) };
}
