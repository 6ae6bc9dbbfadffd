// Puffs and flat pieces as closed meshes without any order in them, for tests of solids without a page.

/** How far the outline of a blob is from its middle, in this direction. */
const reach =
  ({ radius, lobes, wave, turn }) =>
  (angle) =>
    radius * (1 + wave * Math.sin(lobes * angle + turn));

/** A mesh of these points and triangles, both in an order that says nothing of how they were made. */
function shuffled(points, triangles, random) {
  const order = points
    .map((_, i) => [random(), i])
    .sort((a, b) => a[0] - b[0])
    .map(([, i]) => i);
  const place = Array.from({ length: points.length });
  order.forEach((from, to) => {
    place[from] = to;
  });
  const mixed = triangles
    .map((corners) => [random(), corners])
    .sort((a, b) => a[0] - b[0])
    .map(([, corners]) => corners.map((v) => place[v]));
  const positions = order.flatMap((i) => points[i]);
  const extent = Math.max(...positions.map(Math.abs));
  const uv = order.flatMap((i) => points[i].slice(0, 2).map((x) => 0.5 + x / (2.01 * extent)));
  return { positions: new Float32Array(positions), uv: new Float32Array(uv), triangles: new Uint32Array(mixed.flat()) };
}

const defaults = { radius: 0.3, lobes: 3, wave: 0.15, turn: 0, around: 24 };

/** A blob that swells to `height` in front, and as far to the back unless it is one-sided: then its back is flat. */
export function puff(random, { rings = 6, height = 0.2, oneSided = false, ...outline } = {}) {
  const shape = { ...defaults, ...outline },
    { around } = shape,
    far = reach(shape);
  const points = [],
    triangles = [];
  /** One side, from its middle to the rim, which is that of the other side too. */
  const side = (sign, high) => {
    const first = points.length;
    const at = (ring, j) =>
      ring === 0 ? first : ring === rings ? j % around : first + 1 + (ring - 1) * around + (j % around);
    points.push([0, 0, sign * high]);
    for (let ring = 1; ring < rings; ring += 1) {
      for (let j = 0; j < around; j += 1) {
        const share = Math.sin((Math.PI / 2) * (ring / rings)),
          angle = (2 * Math.PI * j) / around,
          r = share * far(angle);
        points.push([r * Math.cos(angle), r * Math.sin(angle), sign * high * Math.cos((Math.PI / 2) * (ring / rings))]);
      }
    }
    for (let ring = 0; ring < rings; ring += 1) {
      for (let j = 0; j < around; j += 1) {
        const [a, b, c, d] = [at(ring, j), at(ring + 1, j), at(ring + 1, j + 1), at(ring, j + 1)];
        for (const corners of ring === 0
          ? [[a, b, c]]
          : [
              [a, b, c],
              [a, c, d],
            ])
          triangles.push(sign > 0 ? corners : corners.toReversed());
      }
    }
  };
  for (let j = 0; j < around; j += 1) {
    const angle = (2 * Math.PI * j) / around;
    points.push([far(angle) * Math.cos(angle), far(angle) * Math.sin(angle), 0]);
  }
  side(1, height);
  side(-1, oneSided ? 0 : height);
  return shuffled(points, triangles, random);
}

/** A blob of a thickness with straight walls, and with a hole of that share of it unless it is 0. */
export function sheet(random, { thickness = 0.1, hole = 0, ...outline } = {}) {
  const shape = { ...defaults, ...outline },
    { around } = shape,
    far = reach(shape);
  const points = [],
    triangles = [];
  const ring = (share, z) => {
    const first = points.length;
    for (let j = 0; j < around; j += 1) {
      const angle = (2 * Math.PI * j) / around,
        r = share * far(angle);
      points.push([r * Math.cos(angle), r * Math.sin(angle), z]);
    }
    return (j) => first + (j % around);
  };
  const middle = (z) => {
    points.push([0, 0, z]);
    return () => points.length - 1;
  };
  const strip = (from, to) => {
    for (let j = 0; j < around; j += 1) triangles.push([from(j), to(j), to(j + 1)], [from(j), to(j + 1), from(j + 1)]);
  };
  const top = ring(1, thickness / 2),
    bottom = ring(1, -thickness / 2);
  strip(top, bottom);
  if (hole > 0) {
    const innerTop = ring(hole, thickness / 2),
      innerBottom = ring(hole, -thickness / 2);
    strip(innerTop, top);
    strip(innerBottom, innerTop);
    strip(bottom, innerBottom);
  } else {
    for (const [rim, z, sign] of [
      [top, thickness / 2, 1],
      [bottom, -thickness / 2, -1],
    ]) {
      const hub = middle(z)();
      for (let j = 0; j < around; j += 1)
        triangles.push(sign > 0 ? [hub, rim(j), rim(j + 1)] : [hub, rim(j + 1), rim(j)]);
    }
  }
  return shuffled(points, triangles, random);
}
