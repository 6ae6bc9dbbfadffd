// What the ghost hand draws in the steps of a task: one line each, about the middle of the paper, in shares of its shorter
// side. Where something is drawn already, that takes the place of what the ghost hand drew for it.

export type Drawing = [x: number, y: number][];

/** A line, and what it is drawn on: null is empty paper. */
export interface Example {
  line: Drawing;
  on: Drawing | null;
}

/** Left, top, right and bottom. */
type Box = [number, number, number, number];

function boxOf(line: Drawing): Box {
  const xs = line.map(([x]) => x),
    ys = line.map(([, y]) => y);
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}

/** The line on a paper of this size, in its pixels; null: it does not belong on what is there. `drawn`: around that. */
export function exampleOn(
  { line, on }: Example,
  { width, height, drawn }: { width: number; height: number; drawn: Box | null },
): Drawing | null {
  if ((on === null) !== (drawn === null)) return null;
  const side = Math.min(width, height);
  if (on === null || drawn === null) return line.map(([x, y]) => [width / 2 + x * side, height / 2 + y * side]);
  const [left, top, right, bottom] = boxOf(on);
  const size: [number, number] = [drawn[2] - drawn[0], drawn[3] - drawn[1]];
  // A straight line has no width to go by.
  const alike = Math.max(...size) / Math.max(right - left, bottom - top);
  const across = right > left && bottom > top ? size[0] / (right - left) : alike,
    down = right > left && bottom > top ? size[1] / (bottom - top) : alike;
  const within = (at: number, length: number) => Math.min(Math.max(at, 0.02 * length), 0.98 * length);
  return line.map(([x, y]) => [
    within((drawn[0] + drawn[2]) / 2 + (x - (left + right) / 2) * across, width),
    within((drawn[1] + drawn[3]) / 2 + (y - (top + bottom) / 2) * down, height),
  ]);
}

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

const kSausage = bothSides([
  [0.25, -0.12],
  [0.35, -0.1],
  [0.39, 0],
  [0.35, 0.1],
  [0.25, 0.12],
]);
const kVase = bothSides([
  [0.15, -0.38],
  [0.09, -0.22],
  [0.21, -0.02],
  [0.22, 0.14],
  [0.12, 0.36],
  [0.06, 0.38],
]);
const kMug = bothSides([
  [0.18, -0.26],
  [0.2, -0.24],
  [0.2, 0.2],
  [0.16, 0.26],
]);
const kBird = rounded([
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
const kBody: Drawing = [
  [0, -0.15],
  [0, 0.2],
];

const onPaper = (line: Drawing): Example => ({ line, on: null });

/** In the order of the steps that are drawn. */
export const kExamples = {
  sausage: [
    onPaper(kSausage),
    {
      line: [
        [-0.37, 0],
        [0.37, 0],
      ],
      on: kSausage,
    },
  ],
  vase: [
    onPaper(kVase),
    {
      line: [
        [0, -0.36],
        [0, 0.36],
      ],
      on: kVase,
    },
  ],
  mug: [
    onPaper(kMug),
    {
      line: [
        [0, -0.25],
        [0, 0.25],
      ],
      on: kMug,
    },
    {
      line: [
        [0.17, -0.14],
        [0.28, -0.15],
        [0.33, -0.08],
        [0.33, 0.06],
        [0.28, 0.13],
        [0.17, 0.12],
      ],
      on: kMug,
    },
  ],
  bird: [
    onPaper(kBird),
    {
      line: rounded([
        [0.12, -0.12],
        [0.17, 0.02],
        [-0.02, 0.11],
        [-0.22, 0.04],
        [-0.02, -0.04],
      ]),
      on: kBird,
    },
  ],
  /** Body; head, arms and legs, a line each. */
  robot: [
    onPaper(kBody),
    {
      line: [
        [0, -0.34],
        [0, -0.12],
      ],
      on: kBody,
    },
    {
      line: [
        [-0.28, -0.08],
        [0.28, -0.08],
      ],
      on: kBody,
    },
    {
      line: [
        [-0.1, 0.42],
        [-0.04, 0.18],
        [0.04, 0.18],
        [0.1, 0.42],
      ],
      on: kBody,
    },
  ],
} satisfies Record<string, [Example, ...Example[]]>;
