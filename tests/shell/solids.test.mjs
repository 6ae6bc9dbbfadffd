// The solver of solids without a page: whatever parts it is given, what comes out is closed and outward or says why
// there is none.
import assert from 'node:assert/strict';
import test from 'node:test';
import {
  fresh,
  lawful,
  library,
  loft,
  measure,
  near,
  node,
  rod,
  seeded,
  shell,
  shifted,
  solve,
  turned,
} from '../browser/support/solids.mjs';

test('join, cut and common of two parts hold what sets say', () => {
  const kernel = fresh(),
    meshes = { rod: loft() };
  const alone = measure(meshes.rod).volume;
  const pair = [rod(1), rod(2, turned(Math.PI / 2, 0.5, -0.5))];
  const [join, cut, common] = ['join', 'cut', 'common'].map(
    (kind) => lawful(solve(kernel, [node(pair, { kind })], meshes), kind).volume,
  );
  near(join, 2 * alone - common, 1e-5, 'join');
  near(cut, alone - common, 1e-5, 'cut');
  // Two round bars of radius r that cross share 16/3 r³ (Steinmetz); ours are 16-gons.
  near(common, (16 / 3) * 0.1 ** 3, 0.06, 'common');
});

test('every face belongs to its part and keeps its place in the picture', () => {
  const { mesh } = solve(fresh(), [node([rod(7), rod(9, shifted(0.4, 0.05))])], { rod: loft() });
  assert.deepEqual([...new Set(mesh.runs.map((run) => run.part))].sort(), [7, 9]);
  for (const { part, first, count } of mesh.runs) {
    for (const v of mesh.triangles.subarray(3 * first, 3 * (first + count))) {
      // u runs along the rod from 0 to 1.
      assert.ok(Math.abs(mesh.uv[2 * v] - (mesh.positions[3 * v] - (part === 9 ? 0.4 : 0))) < 1e-3);
    }
  }
});

test('parts that coincide, touch or lie a hair apart make solids', () => {
  const kernel = fresh(),
    meshes = { rod: loft() };
  const alone = measure(meshes.rod).volume;
  const volume = (operands, what) => lawful(solve(kernel, [node(operands)], meshes), what).volume;
  near(volume([rod(1), rod(2)], 'the same twice'), alone, 1e-4, 'the same twice');
  near(
    volume(
      Array.from({ length: 50 }, (_, i) => rod(i + 1)),
      'fifty times the same',
    ),
    alone,
    1e-4,
    'fifty times the same',
  );
  near(volume([rod(1), rod(2, shifted(1e-9, -1e-9, 1e-9))], 'a hair apart'), alone, 1e-4, 'a hair apart');
  near(volume([rod(1), rod(2, shifted(0, 0.2))], 'side by side'), 2 * alone, 1e-4, 'side by side');
  near(volume([rod(1), rod(2, shifted(1))], 'end to end'), 2 * alone, 1e-4, 'end to end');
  assert.deepEqual(solve(kernel, [node([rod(1), rod(2)], { kind: 'cut' })]).failure, { error: 'SolidEmpty' });
  assert.deepEqual(solve(kernel, [node([rod(1), rod(2, shifted(0, 5))], { kind: 'common' })]).failure, {
    error: 'SolidEmpty',
  });
});

test('random models of up to twenty parts are solids or empty', () => {
  for (let seed = 1; seed <= 25; seed += 1) {
    const random = seeded(seed),
      kernel = fresh();
    const meshes = Object.fromEntries(
      Array.from({ length: 4 }, (_, i) => [
        `m${i}`,
        loft({
          rings: 5 + Math.floor(20 * random()),
          around: 4 + Math.floor(14 * random()),
          radius: 0.04 + 0.15 * random(),
          bend: 2 * random(),
          wave: 0.3 * random(),
        }),
      ]),
    );
    const nodes = [];
    const operands = Array.from({ length: 2 + Math.floor(19 * random()) }, (_, i) => {
      const near = Math.floor(4 * random()) * 0.1;
      return {
        mesh: `m${Math.floor(4 * random())}`,
        part: i + 1,
        matrix: random() < 0.2 ? shifted(near) : turned(6 * random(), near, random() - 0.5, 0.2 * random()),
      };
    });
    while (operands.length > 1) {
      const taken = operands.splice(0, Math.min(operands.length, 2 + Math.floor(4 * random())));
      nodes.push(
        node(taken, {
          kind: ['join', 'join', 'join', 'cut', 'common'][Math.floor(5 * random())],
          step: nodes.length + 1,
        }),
      );
      operands.push({ node: nodes.at(-1).key });
    }
    const solved = solve(kernel, nodes, meshes);
    if (solved.failure) assert.equal(solved.failure.error, 'SolidEmpty', `seed ${seed}`);
    else {
      const { euler, shells } = lawful(solved, `seed ${seed}`);
      assert.equal(euler, 2 * shells - 2 * solved.mesh.genus, `seed ${seed}: genus`);
      assert.ok(solved.mesh.genus >= 0, `seed ${seed}: genus`);
    }
  }
});

test('a step that the library refuses names the part that it fails with, and where that is', () => {
  /** Refuses unions of three and more, and every mesh without a source. */
  const { Manifold } = library,
    refuse = () => {
      throw new Error('refused');
    };
  const meshes = { rod: loft() },
    parts = [rod(7), rod(8, shifted(0, 0.05)), rod(9, shifted(0, 3))];
  const { failure } = solve(
    fresh({ union: (solids) => (solids.length > 2 ? refuse() : Manifold.union(solids)) }),
    [node(parts)],
    meshes,
  );
  assert.deepEqual([failure.error, failure.part, Math.round(failure.at[1])], ['SolidFailed', 9, 3]);
  const hollow = solve(
    fresh({ ofMesh: (mesh) => (mesh.numTri > 1000 ? refuse() : Manifold.ofMesh(mesh)) }),
    [node([rod(7)], { kind: 'hollow' })],
    meshes,
  );
  assert.deepEqual([hollow.failure.error, hollow.failure.part], ['SolidFailed', 7]);
});

test('a library that breaks down is not asked again: its worker ends', () => {
  const breakDown = () => {
    throw new WebAssembly.RuntimeError('memory access out of bounds');
  };
  assert.throws(
    () => solve(fresh({ union: breakDown }), [node([rod(1), rod(2, shifted(0.4))])], { rod: loft() }),
    WebAssembly.RuntimeError,
  );
});
