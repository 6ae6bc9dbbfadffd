// Meshes that go through themselves, do not, or nearly do: the same numbers as in tests/unit/mesh/self_crossing_test.cpp,
// which asks the same questions of the engine. What is true of each is in tests/golden/crossing_verdicts.txt.
import { seeded } from '../../support/random.mjs';

const kFaces = [
  [0, 2, 3, 1],
  [4, 5, 7, 6],
  [0, 1, 5, 4],
  [2, 6, 7, 3],
  [0, 4, 6, 2],
  [1, 3, 7, 5],
];

/** Six triangles anywhere. */
function soup(random) {
  const points = [];
  for (let t = 0; t < 6; t += 1) {
    const centre = [random(), random(), random()];
    for (let c = 0; c < 3; c += 1) for (let k = 0; k < 3; k += 1) points.push(centre[k] + 0.6 * random());
  }
  return { points, triangles: points.slice(0, 18).map((_, i) => i) };
}

/** Two boxes askew, one of which stands into the other by a share of it between 10⁻⁸ and 10⁻⁴, or is as far away. */
function boxes(random) {
  const axes = [0, 1, 2].map((k) => [0, 1, 2].map((j) => (j === k ? 1 : 0.3 * (random() - 0.5))));
  const depth = (random() < 0.25 ? -1 : 1) * 10 ** -(4 + Math.floor(5 * random())) * (1 + random()),
    points = [],
    triangles = [];
  for (const [x, y, z] of [
    [0, 0, 0],
    [1 - depth, 0.2 * random(), 0.2 * random()],
  ]) {
    const first = points.length / 3;
    for (let v = 0; v < 8; v += 1) {
      const at = [x + (v & 1), y + ((v >> 1) & 1), z + (v >> 2)];
      for (let k = 0; k < 3; k += 1) points.push(at[0] * axes[0][k] + at[1] * axes[1][k] + at[2] * axes[2][k]);
    }
    for (const [a, b, c, d] of kFaces) triangles.push(first + a, first + b, first + c, first + a, first + c, first + d);
  }
  return { points, triangles };
}

/** The first half are triangles anywhere, the second half boxes. */
export function crossingScene(number, half = 120) {
  const random = seeded(2654435761 * (number + 1)),
    { points, triangles } = number < half ? soup(random) : boxes(random);
  return { positions: Float32Array.from(points), triangles: Uint32Array.from(triangles) };
}
