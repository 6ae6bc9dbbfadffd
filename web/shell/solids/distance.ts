// Signed distance to a closed mesh on a grid, exact near the surface: what hollow solids and smooth seams are
// made of. Negative inside.
import { at, isWithin } from './grid.ts';
import type { Grid } from './grid.ts';

/** A share of a length; of a side without any, where corners are at one place, the start. */
function share(part: number, whole: number): number {
  return whole > 0 ? part / whole : 0;
}

/** Square of the distance from a point to the triangle abc (Ericson, Real-Time Collision Detection 5.1.5). */
function squaredDistance(p: Float32Array, a: number, b: number, c: number, x: number, y: number, z: number): number {
  const abx = p[b]! - p[a]!,
    aby = p[b + 1]! - p[a + 1]!,
    abz = p[b + 2]! - p[a + 2]!;
  const acx = p[c]! - p[a]!,
    acy = p[c + 1]! - p[a + 1]!,
    acz = p[c + 2]! - p[a + 2]!;
  const apx = x - p[a]!,
    apy = y - p[a + 1]!,
    apz = z - p[a + 2]!;
  const d1 = abx * apx + aby * apy + abz * apz,
    d2 = acx * apx + acy * apy + acz * apz;
  const bb = abx * abx + aby * aby + abz * abz,
    cc = acx * acx + acy * acy + acz * acz,
    bc = abx * acx + aby * acy + abz * acz;
  const d3 = d1 - bb,
    d4 = d2 - bc,
    d5 = d1 - bc,
    d6 = d2 - cc;
  let v = 0,
    w = 0;
  const va = d3 * d6 - d5 * d4,
    vb = d5 * d2 - d1 * d6,
    vc = d1 * d4 - d3 * d2;
  if (d1 <= 0 && d2 <= 0) v = w = 0;
  else if (d3 >= 0 && d4 <= d3) v = 1;
  else if (vc <= 0 && d1 >= 0 && d3 <= 0) v = share(d1, d1 - d3);
  else if (d6 >= 0 && d5 <= d6) w = 1;
  else if (vb <= 0 && d2 >= 0 && d6 <= 0) w = share(d2, d2 - d6);
  else if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    w = share(d4 - d3, d4 - d3 + (d5 - d6));
    v = 1 - w;
  } else {
    const sum = va + vb + vc;
    v = share(vb, sum);
    w = share(vc, sum);
  }
  const dx = apx - v * abx - w * acx,
    dy = apy - v * aby - w * acy,
    dz = apz - v * abz - w * acz;
  return dx * dx + dy * dy + dz * dz;
}

/** Above 0 where a point lies to the left of an edge, given from that point; never 0, and the opposite for the edge the other way. */
function sideOf(fromY: number, fromZ: number, toY: number, toZ: number): number {
  const turn = fromY * toZ - toY * fromZ;
  if (turn !== 0) return turn;
  return fromY < toY || (fromY === toY && fromZ < toZ) ? Number.MIN_VALUE : -Number.MIN_VALUE;
}

export class DistanceField {
  /** At the points of the grid. */
  readonly values: Float32Array;

  /**
   * Distances beyond `reach` are only known to be that large. `where` they are asked for: everywhere, inside, or at the
   * points that are marked; elsewhere they are exact next to the surface alone, or not known.
   */
  constructor(
    private readonly positions: Float32Array,
    private readonly triangles: Uint32Array,
    private readonly grid: Grid,
    reach: number,
    where: 'all' | 'inside' | Uint8Array = 'all',
  ) {
    const [nx, ny, nz] = grid.size;
    this.values = new Float32Array(nx * ny * nz).fill(reach);
    const inside = this.insides();
    const marked = where instanceof Uint8Array ? where : null;
    this.spread(this.scan(marked), where === 'inside' ? inside : marked);
    for (let i = 0; i < inside.length; i += 1) if (inside[i]! > 0) this.values[i] = -this.values[i]!;
  }

  /** Interpolated between the grid's points; outside the grid the value at its rim. */
  at(x: number, y: number, z: number): number {
    return at(this.grid, this.values, x, y, z);
  }

  /** Distances of the points next to every triangle, and which triangle that is. */
  private scan(marked: Uint8Array | null): Int32Array {
    const { positions: p, triangles, values } = this;
    const { min, step, size } = this.grid;
    const [nx, ny] = size;
    const nearest = new Int32Array(values.length).fill(-1);
    const low = [0, 0, 0],
      high = [0, 0, 0],
      middle = [0, 0, 0];
    for (let t = 0; t < triangles.length; t += 3) {
      const a = 3 * triangles[t]!,
        b = 3 * triangles[t + 1]!,
        c = 3 * triangles[t + 2]!;
      let radius = 0;
      for (let k = 0; k < 3; k += 1) {
        const least = Math.min(p[a + k]!, p[b + k]!, p[c + k]!),
          most = Math.max(p[a + k]!, p[b + k]!, p[c + k]!);
        low[k] = Math.max(0, Math.ceil((least - min[k]!) / step - 1));
        high[k] = Math.min(size[k]! - 1, Math.floor((most - min[k]!) / step + 1));
        middle[k] = (least + most) / 2;
        radius += (most - least) ** 2 / 4;
      }
      radius = Math.sqrt(radius);
      for (let z = low[2]!; z <= high[2]!; z += 1) {
        const pz = min[2] + z * step,
          dz = pz - middle[2]!;
        for (let y = low[1]!; y <= high[1]!; y += 1) {
          const py = min[1] + y * step,
            dy = py - middle[1]!;
          for (let x = low[0]!; x <= high[0]!; x += 1) {
            const i = x + nx * (y + ny * z),
              px = min[0] + x * step,
              dx = px - middle[0]!;
            if (marked && marked[i] === 0) continue;
            // All of the triangle lies in a ball about its middle.
            const known = values[i]!,
              beyond = known + radius;
            if (dx * dx + dy * dy + dz * dz >= beyond * beyond) continue;
            const d = squaredDistance(p, a, b, c, px, py, pz);
            if (d >= known * known) continue;
            values[i] = Math.sqrt(d);
            nearest[i] = t;
          }
        }
      }
    }
    return nearest;
  }

  /** What is nearest to a neighbour may be nearest here: sweeps in all eight directions, over what is above 0 in `marked`. */
  private spread(nearest: Int32Array, marked: Int8Array | Uint8Array | null): void {
    const { positions: p, triangles, values } = this;
    const { min, step } = this.grid;
    const [nx, ny, nz] = this.grid.size;
    const offer = (i: number, from: number, x: number, y: number, z: number) => {
      const t = nearest[from]!;
      if (t < 0 || t === nearest[i]! || values[from]! >= values[i]! + step) return;
      const d = squaredDistance(
        p,
        3 * triangles[t]!,
        3 * triangles[t + 1]!,
        3 * triangles[t + 2]!,
        min[0] + x * step,
        min[1] + y * step,
        min[2] + z * step,
      );
      if (d >= values[i]! * values[i]!) return;
      values[i] = Math.sqrt(d);
      nearest[i] = t;
    };
    for (let sweep = 0; sweep < 8; sweep += 1) {
      const sx = sweep & 1 ? -1 : 1,
        sy = sweep & 2 ? -1 : 1,
        sz = sweep & 4 ? -1 : 1;
      for (let k = 0; k < nz; k += 1) {
        const z = sz > 0 ? k : nz - 1 - k;
        for (let j = 0; j < ny; j += 1) {
          const y = sy > 0 ? j : ny - 1 - j;
          for (let n = 0; n < nx; n += 1) {
            const x = sx > 0 ? n : nx - 1 - n,
              i = x + nx * (y + ny * z);
            if (marked && marked[i]! <= 0) continue;
            if (n > 0) offer(i, i - sx, x, y, z);
            if (j > 0) offer(i, i - sy * nx, x, y, z);
            if (k > 0) offer(i, i - sz * nx * ny, x, y, z);
          }
        }
      }
    }
  }

  /** Above 0 inside: how often a line along x has gone in up to a point, less how often it has gone out. */
  private insides(): Int8Array {
    const { positions: p, triangles } = this;
    const { min, step, size } = this.grid;
    const [nx, ny, nz] = size;
    const turns = new Int8Array(nx * ny * nz);
    // A little off the grid, so that no line runs along an edge of the mesh.
    const offY = min[1] + step * 1.37e-4,
      offZ = min[2] + step * 2.11e-4;
    for (let t = 0; t < triangles.length; t += 3) {
      const a = 3 * triangles[t]!,
        b = 3 * triangles[t + 1]!,
        c = 3 * triangles[t + 2]!;
      const ay = p[a + 1]!,
        az = p[a + 2]!,
        by = p[b + 1]!,
        bz = p[b + 2]!,
        cy = p[c + 1]!,
        cz = p[c + 2]!;
      const y1 = Math.min(ny - 1, Math.floor((Math.max(ay, by, cy) - offY) / step)),
        z1 = Math.min(nz - 1, Math.floor((Math.max(az, bz, cz) - offZ) / step));
      for (let z = Math.max(0, Math.ceil((Math.min(az, bz, cz) - offZ) / step)); z <= z1; z += 1) {
        for (let y = Math.max(0, Math.ceil((Math.min(ay, by, cy) - offY) / step)); y <= y1; y += 1) {
          const py = offY + y * step,
            pz = offZ + z * step;
          // Which side of each edge the line passes. Of the two faces at an edge both compute the same number but for its
          // sign, so that a line passes through just one of them however thin they are.
          const u = sideOf(by - py, bz - pz, cy - py, cz - pz),
            v = sideOf(cy - py, cz - pz, ay - py, az - pz),
            w = sideOf(ay - py, az - pz, by - py, bz - pz);
          const leaves = u > 0;
          if (v > 0 !== leaves || w > 0 !== leaves) continue;
          const x = Math.max(0, Math.ceil(((u * p[a]! + v * p[b]! + w * p[c]!) / (u + v + w) - min[0]) / step));
          // An outward face that turns to the left looks towards +x: there the line leaves.
          if (isWithin(size, x, y, z)) turns[x + nx * (y + ny * z)]! += leaves ? -1 : 1;
        }
      }
    }
    for (let i = 1; i < turns.length; i += 1) if (i % nx !== 0) turns[i]! += turns[i - 1]!;
    return turns;
  }
}
