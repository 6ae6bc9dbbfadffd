// Signed distance to a closed mesh on a grid, exact near the surface: what hollow solids and smooth seams are
// made of. Negative inside.

export interface Box {
  min: [number, number, number];
  max: [number, number, number];
}

/** Square of the distance from a point to triangle t (Ericson, Real-Time Collision Detection 5.1.5). */
function squaredDistance(p: Float32Array, a: number, b: number, c: number, x: number, y: number, z: number): number {
  const abx = p[b]! - p[a]!, aby = p[b + 1]! - p[a + 1]!, abz = p[b + 2]! - p[a + 2]!;
  const acx = p[c]! - p[a]!, acy = p[c + 1]! - p[a + 1]!, acz = p[c + 2]! - p[a + 2]!;
  const apx = x - p[a]!, apy = y - p[a + 1]!, apz = z - p[a + 2]!;
  const d1 = abx * apx + aby * apy + abz * apz, d2 = acx * apx + acy * apy + acz * apz;
  const bb = abx * abx + aby * aby + abz * abz, cc = acx * acx + acy * acy + acz * acz, bc = abx * acx + aby * acy + abz * acz;
  const d3 = d1 - bb, d4 = d2 - bc, d5 = d1 - bc, d6 = d2 - cc;
  let v = 0, w = 0;
  const va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  if (d1 <= 0 && d2 <= 0) v = w = 0;
  else if (d3 >= 0 && d4 <= d3) v = 1;
  else if (vc <= 0 && d1 >= 0 && d3 <= 0) v = d1 / (d1 - d3);
  else if (d6 >= 0 && d5 <= d6) w = 1;
  else if (vb <= 0 && d2 >= 0 && d6 <= 0) w = d2 / (d2 - d6);
  else if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    w = (d4 - d3) / (d4 - d3 + (d5 - d6));
    v = 1 - w;
  } else {
    const sum = va + vb + vc;
    v = sum > 0 ? vb / sum : 0;
    w = sum > 0 ? vc / sum : 0;
  }
  const dx = apx - v * abx - w * acx, dy = apy - v * aby - w * acy, dz = apz - v * abz - w * acz;
  return dx * dx + dy * dy + dz * dz;
}

export class DistanceField {
  private readonly size: [number, number, number];
  private readonly values: Float32Array;

  /** `step` of the grid; distances beyond `reach` are only known to be that large. */
  constructor(private readonly positions: Float32Array, private readonly triangles: Uint32Array, private readonly box: Box, private readonly step: number, reach: number) {
    this.size = [0, 1, 2].map((k) => Math.max(2, Math.ceil((box.max[k]! - box.min[k]!) / step) + 1)) as [number, number, number];
    const [nx, ny, nz] = this.size;
    this.values = new Float32Array(nx * ny * nz).fill(reach * reach);
    const nearest = this.scan();
    this.spread(nearest);
    this.sign();
  }

  /** Interpolated between the grid's points; outside the grid the value at its rim. */
  at(x: number, y: number, z: number): number {
    const { box, step, values } = this;
    const [nx, ny, nz] = this.size;
    const gx = Math.min(nx - 1.000001, Math.max(0, (x - box.min[0]) / step)), gy = Math.min(ny - 1.000001, Math.max(0, (y - box.min[1]) / step));
    const gz = Math.min(nz - 1.000001, Math.max(0, (z - box.min[2]) / step));
    const ix = gx | 0, iy = gy | 0, iz = gz | 0, fx = gx - ix, fy = gy - iy, fz = gz - iz;
    const i = ix + nx * (iy + ny * iz), up = nx * ny;
    const low = (values[i]! * (1 - fx) + values[i + 1]! * fx) * (1 - fy) + (values[i + nx]! * (1 - fx) + values[i + nx + 1]! * fx) * fy;
    const high = (values[i + up]! * (1 - fx) + values[i + up + 1]! * fx) * (1 - fy) + (values[i + up + nx]! * (1 - fx) + values[i + up + nx + 1]! * fx) * fy;
    return low * (1 - fz) + high * fz;
  }

  /** Squared distances of the points round every triangle, and which triangle that is. */
  private scan(): Int32Array {
    const { positions: p, triangles, box, step, values, size } = this;
    const [nx, ny] = size;
    const nearest = new Int32Array(values.length).fill(-1);
    const low = [0, 0, 0], high = [0, 0, 0];
    for (let t = 0; t < triangles.length; t += 3) {
      const a = 3 * triangles[t]!, b = 3 * triangles[t + 1]!, c = 3 * triangles[t + 2]!;
      for (let k = 0; k < 3; k += 1) {
        const least = Math.min(p[a + k]!, p[b + k]!, p[c + k]!), most = Math.max(p[a + k]!, p[b + k]!, p[c + k]!);
        low[k] = Math.max(0, Math.floor((least - box.min[k]!) / step) - 1);
        high[k] = Math.min(size[k]! - 1, Math.ceil((most - box.min[k]!) / step) + 1);
      }
      for (let z = low[2]!; z <= high[2]!; z += 1) {
        for (let y = low[1]!; y <= high[1]!; y += 1) {
          for (let x = low[0]!; x <= high[0]!; x += 1) {
            const i = x + nx * (y + ny * z);
            const d = squaredDistance(p, a, b, c, box.min[0] + x * step, box.min[1] + y * step, box.min[2] + z * step);
            if (d >= values[i]!) continue;
            values[i] = d;
            nearest[i] = t;
          }
        }
      }
    }
    return nearest;
  }

  /** What is nearest to a neighbour may be nearest here: two rounds of sweeps in all eight directions. */
  private spread(nearest: Int32Array): void {
    const { positions: p, triangles, box, step, values } = this;
    const [nx, ny, nz] = this.size;
    const offer = (i: number, from: number, x: number, y: number, z: number) => {
      const t = nearest[from]!;
      if (t < 0 || t === nearest[i]! || values[from]! >= values[i]! + 3 * step * (Math.sqrt(values[i]!) + step)) return;
      const d = squaredDistance(p, 3 * triangles[t]!, 3 * triangles[t + 1]!, 3 * triangles[t + 2]!, box.min[0] + x * step, box.min[1] + y * step, box.min[2] + z * step);
      if (d >= values[i]!) return;
      values[i] = d;
      nearest[i] = t;
    };
    for (let sweep = 0; sweep < 8; sweep += 1) {
      const sx = sweep & 1 ? -1 : 1, sy = sweep & 2 ? -1 : 1, sz = sweep & 4 ? -1 : 1;
      for (let k = 0; k < nz; k += 1) {
        const z = sz > 0 ? k : nz - 1 - k;
        for (let j = 0; j < ny; j += 1) {
          const y = sy > 0 ? j : ny - 1 - j;
          for (let n = 0; n < nx; n += 1) {
            const x = sx > 0 ? n : nx - 1 - n, i = x + nx * (y + ny * z);
            if (n > 0) offer(i, i - sx, x, y, z);
            if (j > 0) offer(i, i - sy * nx, x, y, z);
            if (k > 0) offer(i, i - sz * nx * ny, x, y, z);
          }
        }
      }
    }
  }

  /** Roots of the squares, negative inside: how often a line along x has gone in and out up to a point. */
  private sign(): void {
    const { positions: p, triangles, box, step, values, size } = this;
    const [nx, ny, nz] = size;
    const rows: { x: number; turn: number }[][] = Array.from({ length: ny * nz }, () => []);
    // A little off the grid, so that no line runs along an edge of the mesh.
    const offY = box.min[1] + step * 1.37e-4, offZ = box.min[2] + step * 2.11e-4;
    for (let t = 0; t < triangles.length; t += 3) {
      const a = 3 * triangles[t]!, b = 3 * triangles[t + 1]!, c = 3 * triangles[t + 2]!;
      const ay = p[a + 1]!, az = p[a + 2]!, by = p[b + 1]!, bz = p[b + 2]!, cy = p[c + 1]!, cz = p[c + 2]!;
      const area = (by - ay) * (cz - az) - (cy - ay) * (bz - az);
      if (area === 0) continue;
      const y1 = Math.min(ny - 1, Math.floor((Math.max(ay, by, cy) - offY) / step)), z1 = Math.min(nz - 1, Math.floor((Math.max(az, bz, cz) - offZ) / step));
      for (let z = Math.max(0, Math.ceil((Math.min(az, bz, cz) - offZ) / step)); z <= z1; z += 1) {
        for (let y = Math.max(0, Math.ceil((Math.min(ay, by, cy) - offY) / step)); y <= y1; y += 1) {
          const py = offY + y * step, pz = offZ + z * step;
          const u = ((by - py) * (cz - pz) - (cy - py) * (bz - pz)) / area, v = ((cy - py) * (az - pz) - (ay - py) * (cz - pz)) / area, w = 1 - u - v;
          if (u < 0 || v < 0 || w < 0) continue;
          // An outward face with area > 0 looks towards +x: there the line leaves.
          rows[y + ny * z]!.push({ x: u * p[a]! + v * p[b]! + w * p[c]!, turn: area > 0 ? -1 : 1 });
        }
      }
    }
    for (let row = 0; row < rows.length; row += 1) {
      const turns = rows[row]!.sort((a, b) => a.x - b.x);
      let inside = 0, next = 0;
      for (let x = 0; x < nx; x += 1) {
        const at = box.min[0] + x * step;
        while (next < turns.length && turns[next]!.x <= at) {
          inside += turns[next]!.turn;
          next += 1;
        }
        const i = x + nx * row, d = Math.sqrt(values[i]!);
        values[i] = inside > 0 ? -d : d;
      }
    }
  }
}
