// Lofts as the engine makes them, and places for them. Each function stands alone, so that a page can be given its text.
/** A loft as the engine makes it: rings of `around` points along a line that bends by `bend`, closed by hubs. */
export function loft({ rings = 24, around = 16, length = 1, radius = 0.1, bend = 0, wave = 0 } = {}) {
  const positions = [],
    uv = [],
    triangles = [];
  const at = (t) => {
    const a = bend * t,
      r = bend === 0 ? 0 : length / bend;
    return bend === 0
      ? { x: length * t, y: 0, across: [0, 1] }
      : { x: r * Math.sin(a), y: r - r * Math.cos(a), across: [-Math.sin(a), Math.cos(a)] };
  };
  for (let i = 0; i < rings; i += 1) {
    const t = i / (rings - 1),
      { x, y, across } = at(t),
      r = radius * (1 + wave * Math.sin(9 * t));
    for (let j = 0; j < around; j += 1) {
      const angle = (2 * Math.PI * j) / around;
      positions.push(x + across[0] * r * Math.cos(angle), y + across[1] * r * Math.cos(angle), -r * Math.sin(angle));
      uv.push(t, j / around);
    }
  }
  for (let i = 0; i + 1 < rings; i += 1) {
    for (let j = 0; j < around; j += 1) {
      const l = (j + 1) % around,
        [a0, a1, b0, b1] = [i * around + j, i * around + l, (i + 1) * around + j, (i + 1) * around + l];
      triangles.push(a0, b0, b1, a0, b1, a1);
    }
  }
  for (const [ring, t] of [
    [0, 0],
    [rings - 1, 1],
  ]) {
    const { x, y } = at(t),
      hub = positions.length / 3;
    positions.push(x, y, 0);
    uv.push(t, 0.5);
    for (let j = 0; j < around; j += 1) {
      const [a, b] = [ring * around + j, ring * around + ((j + 1) % around)];
      triangles.push(...(ring === 0 ? [hub, a, b] : [a, hub, b]));
    }
  }
  return { positions: new Float32Array(positions), uv: new Float32Array(uv), triangles: new Uint32Array(triangles) };
}

export const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
export const shifted = (x, y = 0, z = 0) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];
export function turned(angle, x = 0, y = 0, z = 0) {
  return [Math.cos(angle), Math.sin(angle), 0, 0, -Math.sin(angle), Math.cos(angle), 0, 0, 0, 0, 1, 0, x, y, z, 1];
}
