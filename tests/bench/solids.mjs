// How long the solver of solids takes, with the code that its worker runs: npm run bench, or node tests/bench/solids.mjs.
import { fresh, loft, node, seeded, shifted, turned } from '../browser/support/solids.mjs';

/** 63 bands of 64 quads and two lids of 64 triangles: 8,192. */
const kFine = { rings: 64, around: 64, length: 1, radius: 0.12 };
const kRuns = 7;

/** By the clock, and the least that the processor was at it: what else the machine does is not in that. */
function summary(times) {
  const sorted = times.map(({ wall }) => wall).sort((a, b) => a - b);
  return {
    min_ms: sorted[0],
    median_ms: sorted[sorted.length >> 1],
    min_cpu_ms: Math.min(...times.map(({ cpu }) => cpu)),
    count: sorted.length,
  };
}

/** What the worker does for one request, from the message to the mesh that goes back. */
function ask(kernel, nodes, meshes) {
  let solved;
  const work = kernel.solve({ id: 1, nodes, wanted: [nodes.at(-1).key], meshes }, (each) => {
    solved = each;
  });
  while (!work.next().done);
  if (!solved.mesh) throw new Error(`The benchmark's solid failed: ${solved.failure?.error}`);
  return solved.mesh;
}

function timed(times, work) {
  const start = performance.now(),
    before = process.cpuUsage();
  work();
  const { user, system } = process.cpuUsage(before);
  times.push({ wall: performance.now() - start, cpu: (user + system) / 1000 });
}

/** Bars that lie over one another crosswise, each in its own mesh, as the parts of a model are. */
function crowd(count, shape = {}) {
  const random = seeded(11),
    meshes = {};
  const operands = Array.from({ length: count }, (_, i) => {
    meshes[`m${i}`] = loft({ ...kFine, bend: random() - 0.5, wave: 0.2 * random(), ...shape });
    return { mesh: `m${i}`, part: i + 1, matrix: turned(i * 0.7, 0.25 * random(), 0.25 * random(), 0.04 * random()) };
  });
  return { meshes, operands };
}

/** A fresh worker's first answer; the very first is before the library's code is at its quickest. */
function anew(make) {
  const times = [];
  for (let run = 0; run <= kRuns; run += 1) {
    const { meshes, nodes } = make();
    timed(times, () => ask(fresh(), nodes, meshes));
  }
  return { first_ms: times[0].wall, ...summary(times.slice(1)) };
}

/** Answers after the first while something is edited, in one worker, which makes ready between them where the second part is chosen. */
function edited(make, edit, chosen = false) {
  const times = [],
    kernel = fresh(),
    model = make();
  ask(kernel, model.nodes, model.meshes);
  // The first edit is where the worker learns which part is in hand.
  for (let run = 0; run <= kRuns; run += 1) {
    if (chosen) for (const work = kernel.ahead(2); !work.next().done;);
    const { nodes, meshes } = edit(model, run);
    timed(times, () => ask(kernel, nodes, meshes));
  }
  return { first_ms: times[0].wall, ...summary(times.slice(1)) };
}

const joined =
  (count, more = {}, shape = {}) =>
  () => {
    const { meshes, operands } = crowd(count, shape);
    return { meshes, operands, nodes: [node(operands, more)] };
  };
const hollowed =
  (more = {}) =>
  () => ({
    meshes: { rod: loft({ ...kFine, radius: 0.25 }) },
    nodes: [
      node([{ mesh: 'rod', part: 1, matrix: shifted(0) }], { kind: 'hollow', wall: 0.03, opening: [1, 0, 0], ...more }),
    ],
  });

/** Another mesh for the second part. */
function otherMesh({ operands }, run, more = {}) {
  const meshes = { [`edit${run}`]: loft({ ...kFine, bend: 0.3, wave: 0.03 * (run + 1) }) };
  return {
    meshes,
    nodes: [
      node(
        operands.map((each, i) => (i === 1 ? { ...each, mesh: `edit${run}` } : each)),
        more,
      ),
    ],
  };
}
/** The second part somewhere else. */
function otherPlace({ operands }, run, more = {}) {
  return {
    meshes: {},
    nodes: [
      node(
        operands.map((each, i) => (i === 1 ? { ...each, matrix: turned(0.1 * run, 0.2) } : each)),
        more,
      ),
    ],
  };
}
/** A scooped out rod with a handle; each time it has another handle. */
function mug() {
  const body = {
    ...node([{ mesh: 'rod', part: 1, matrix: shifted(0) }], { kind: 'hollow', wall: 0.03, opening: [1, 0, 0] }),
    step: 2,
  };
  const meshes = { rod: loft({ ...kFine, radius: 0.25 }), handle: handleOf(0) };
  return { meshes, body, nodes: [body, mugOf(body, 'handle')] };
}
const handleOf = (more) => loft({ ...kFine, length: 0.7, radius: 0.04 + 0.001 * more, bend: 3 });
const mugOf = (body, mesh) => node([{ node: body.key }, { mesh, part: 2, matrix: turned(0.1, 0.2, 0.22) }]);
const otherHandle = ({ body }, run) => ({
  meshes: { [`edit${run}`]: handleOf(run + 1) },
  nodes: [body, mugOf(body, `edit${run}`)],
});
function hollowEdit(more) {
  return (_, run) => ({
    meshes: { [`rod${run}`]: loft({ ...kFine, radius: 0.25, wave: 0.01 * (run + 1) }) },
    nodes: [
      node([{ mesh: `rod${run}`, part: 1, matrix: shifted(0) }], {
        kind: 'hollow',
        wall: 0.03,
        opening: [1, 0, 0],
        ...more,
      }),
    ],
  });
}

const kPreviewOf = [
  ['preview: a rib of one of ten', 'again after a rib of one of ten'],
  ['preview: scoop out', 'scoop out a loft of 8,192 triangles'],
  ['preview: round the seam of two', 'round the seam of two lofts'],
  ['preview: cut', 'cut one loft out of another'],
];

/** Stage times by name, {first_ms, min_ms, median_ms, min_cpu_ms, count}, of previews share_of_full, too. */
export function solidTimes() {
  const coarse = { coarse: true };
  const found = {
    'stick two lofts of 8,192 triangles together': anew(joined(2)),
    'stick ten lofts of 8,192 triangles together': anew(joined(10)),
    'stick ten lofts of 2,048 triangles together': anew(joined(10, {}, { rings: 32, around: 32 })),
    'again after a rib of one of ten': edited(joined(10), otherMesh),
    'again after a rib of one of ten that was chosen': edited(joined(10), otherMesh, true),
    'again after one of ten was moved': edited(joined(10), otherPlace),
    'again after one of ten that was chosen was moved': edited(joined(10), otherPlace, true),
    'again after a rib of one of two': edited(joined(2), otherMesh),
    'again after a rib of the handle of a mug': edited(mug, otherHandle, true),
    'scoop out a loft of 8,192 triangles': anew(hollowed()),
    'round the seam of two lofts': anew(joined(2, { blend: 0.03 })),
    'cut one loft out of another': anew(joined(2, { kind: 'cut' })),
    'preview: a rib of one of ten': edited(joined(10, coarse), (model, run) => otherMesh(model, run, coarse)),
    'preview: scoop out': edited(hollowed(coarse), hollowEdit(coarse)),
    'preview: round the seam of two': edited(joined(2, { ...coarse, blend: 0.03 }), (model, run) =>
      otherMesh(model, run, { ...coarse, blend: 0.03 }),
    ),
    'preview: cut': edited(joined(2, { ...coarse, kind: 'cut' }), (model, run) =>
      otherMesh(model, run, { ...coarse, kind: 'cut' }),
    ),
  };
  // What a preview under the hand takes of the solid that follows it.
  for (const [preview, whole] of kPreviewOf)
    found[preview].share_of_full = found[preview].median_ms / found[whole].median_ms;
  return found;
}

if (import.meta.filename === process.argv[1]) process.stdout.write(`${JSON.stringify(solidTimes(), null, 2)}\n`);
