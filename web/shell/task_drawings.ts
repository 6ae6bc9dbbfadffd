// What the ghost hand draws on paper for the first step of a task: one line each, about the middle of the paper, in shares
// of its shorter side.

export type Drawing = [x: number, y: number][];

/** Twice with its corners cut (Chaikin), and closed. */
function rounded(corners: Drawing): Drawing {
  let points = corners;
  for (let round = 0; round < 2; ++round)
    points = points.flatMap(([ax, ay], i): Drawing => {
      const [bx, by] = points[(i + 1) % points.length]!;
      return [
        [0.75 * ax + 0.25 * bx, 0.75 * ay + 0.25 * by],
        [0.25 * ax + 0.75 * bx, 0.25 * ay + 0.75 * by],
      ];
    });
  return [...points, points[0]!];
}

/** The right side of a thing from its top to its foot, with the same on the left. */
const bothSides = (right: Drawing): Drawing =>
  rounded([...right, ...right.map(([x, y]): [number, number] => [-x, y]).reverse()]);

export const kSausage = bothSides([
  [0.25, -0.12],
  [0.35, -0.1],
  [0.39, 0],
  [0.35, 0.1],
  [0.25, 0.12],
]);
export const kVase = bothSides([
  [0.15, -0.38],
  [0.09, -0.22],
  [0.21, -0.02],
  [0.22, 0.14],
  [0.12, 0.36],
  [0.06, 0.38],
]);
export const kMug = bothSides([
  [0.18, -0.26],
  [0.2, -0.24],
  [0.2, 0.2],
  [0.16, 0.26],
]);
export const kBird = rounded([
  [-0.4, -0.02],
  [-0.2, -0.06],
  [0, -0.16],
  [0.09, -0.27],
  [0.22, -0.29],
  [0.28, -0.21],
  [0.4, -0.16],
  [0.28, -0.12],
  [0.25, 0.02],
  [0.12, 0.15],
  [-0.08, 0.18],
  [-0.22, 0.1],
  [-0.4, 0.1],
]);
/** A line for a body. */
export const kBody: Drawing = [
  [0, -0.15],
  [0, 0.2],
];
