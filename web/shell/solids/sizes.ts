// How large a closed mesh is.
import type { Faces } from './flaps.ts';

export function sizeOf({ vertProperties: p, triVerts }: Pick<Faces, 'vertProperties' | 'triVerts'>): {
  volume: number;
  area: number;
} {
  let volume = 0,
    area = 0;
  for (let t = 0; t < triVerts.length; t += 3) {
    const a = 3 * triVerts[t]!,
      b = 3 * triVerts[t + 1]!,
      c = 3 * triVerts[t + 2]!,
      ax = p[a]!,
      ay = p[a + 1]!,
      az = p[a + 2]!;
    const ux = p[b]! - ax,
      uy = p[b + 1]! - ay,
      uz = p[b + 2]! - az,
      vx = p[c]! - ax,
      vy = p[c + 1]! - ay,
      vz = p[c + 2]! - az;
    const x = uy * vz - uz * vy,
      y = uz * vx - ux * vz,
      z = ux * vy - uy * vx;
    volume += (x * ax + y * ay + z * az) / 6;
    area += Math.sqrt(x * x + y * y + z * z) / 2;
  }
  return { volume, area };
}
