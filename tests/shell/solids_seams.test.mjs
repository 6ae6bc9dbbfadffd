// Rounded seams: of any two parts, of one that is edited, and as parts come and go.
import assert from 'node:assert/strict';
import test from 'node:test';
import {
  counted,
  fresh,
  lawful,
  loft,
  near,
  node,
  rod,
  seeded,
  shifted,
  solve,
  turned,
} from '../browser/support/solids.mjs';

test('a rounded seam adds a little at a join, takes a little at a cut, and stays a solid', () => {
  const kernel = fresh(),
    meshes = { rod: loft({ rings: 30, around: 32 }) };
  const pair = [rod(1), rod(2, turned(Math.PI / 2, 0.5, 0))];
  for (const kind of ['join', 'cut']) {
    const sharp = lawful(solve(kernel, [node(pair, { kind })], meshes), kind).volume;
    const soft = lawful(solve(kernel, [node(pair, { kind, blend: 0.06 })], meshes), `${kind}, rounded`).volume;
    const change = (soft - sharp) * (kind === 'join' ? 1 : -1);
    assert.ok(change > 1e-5 && change < 0.003, `${kind}: ${change}`);
    // The rounding looks as the part that it is nearer to: no face of one part lies on the other's side.
    const { mesh } = solve(kernel, [node(pair, { kind, blend: 0.06 })], meshes);
    const axes = { 1: (x, y, z) => Math.hypot(y, z), 2: (x, y, z) => Math.hypot(x - 0.5, z) };
    for (const { part, first, count } of mesh.runs) {
      for (const v of mesh.triangles.subarray(3 * first, 3 * (first + count))) {
        const [own, other] = [part, 3 - part].map((which) =>
          Math.abs(axes[which](...mesh.positions.subarray(3 * v, 3 * v + 3)) - 0.1),
        );
        assert.ok(
          own < other + 0.02,
          `${kind}: a corner of part ${part} is ${own} from it, and ${other} from the other`,
        );
      }
    }
  }
});

/** A body and limbs that stand in it side by side, away from one another. */
function limbs(kind, blend) {
  const meshes = {
    body: loft({ rings: 24, around: 20, radius: 0.14 }),
    limb: loft({ rings: 20, around: 16, radius: 0.05 }),
  };
  const operands = [
    rod(1, shifted(0), 'body'),
    ...[0.15, 0.4, 0.65, 0.9].map((x, i) => rod(i + 2, turned(1.6, x), 'limb')),
  ];
  const edit = (i, k) => ({
    meshes: { [`edit ${i}`]: loft({ rings: 20, around: 16, radius: 0.05 + 0.002 * (i % 7), bend: 0.1 }) },
    operands: operands.map((each, n) => (n === k ? { ...each, mesh: `edit ${i}` } : each)),
  });
  return { meshes, operands, edit, plan: (of, more = {}) => [node(of, { kind, blend, ...more })] };
}

/** How many seams are rounded while `work` runs: each is where the library's solids have something in common, taken apart. */
const roundedIn = (work) =>
  counted(({ asked }) => {
    work();
    return asked.decompositions;
  });

test('an edit of a part with rounded seams rounds its own seams alone, also in a preview; the solid is the one that all of it anew is', () => {
  for (const kind of ['join', 'cut']) {
    const { meshes, operands, edit, plan } = limbs(kind, 0.02),
      kernel = fresh(),
      sizes = [];
    assert.equal(
      roundedIn(() => solve(kernel, plan(operands), meshes)),
      4,
      `${kind}: of the body and any limb`,
    );
    assert.equal(
      roundedIn(() => {
        for (const work = kernel.ahead(3); !work.next().done;);
      }),
      0,
      `${kind}: they are there`,
    );
    for (let i = 0; i < 30; i += 1) {
      const what = `${kind}, edit ${i}`,
        edited = edit(i, 2),
        coarse = i % 3 === 1,
        asked = plan(edited.operands, { coarse });
      let made = null;
      assert.equal(
        roundedIn(() => {
          made = solve(kernel, asked, edited.meshes);
        }),
        1,
        what,
      );
      if (i < 4) {
        const anew = solve(fresh(), plan(edited.operands, { coarse: false }), { ...meshes, ...edited.meshes }).mesh,
          found = lawful(made, what);
        near(found.volume, anew.volume, coarse ? 1e-3 : 1e-5, `${what}: volume`);
        assert.equal(made.mesh.genus, anew.genus, `${what}: handles`);
        assert.deepEqual(
          [...new Set(made.mesh.runs.map(({ part }) => part))].sort(),
          [...new Set(anew.runs.map(({ part }) => part))].sort(),
          `${what}: parts that show`,
        );
      }
      sizes.push(kernel.counts.solids + kernel.counts.sources);
    }
    // What is kept for undo fills in the first ones.
    assert.ok(sizes.at(-1) <= Math.max(...sizes.slice(0, 15)), `${kind}: ${sizes.join(' ')}`);
    // Of the first one every seam is its own; where nothing is known all is made.
    const wide = loft({ rings: 24, around: 20, radius: 0.15 }),
      others = operands.map((each, i) => (i === 0 ? { ...each, mesh: 'wider' } : each));
    const wider = solve(kernel, plan(others), { ...meshes, wider: wide }).mesh;
    near(
      wider.volume,
      solve(fresh(), plan(others), { ...meshes, wider: wide }).mesh.volume,
      1e-5,
      `${kind}: the first one`,
    );
  }
});

test('a part that comes to a join or leaves it is what all of it anew is, sharp or rounded, in any order', () => {
  for (const blend of [0, 0.02]) {
    const { meshes, operands, plan } = limbs('join', blend),
      kernel = fresh(),
      random = seeded(5);
    for (let i = 0; i < 12; i += 1) {
      const some = operands.filter(() => random() < 0.7).toSorted(() => random() - 0.5);
      if (some.length < 2) continue;
      const asked = plan(some),
        made = lawful(solve(kernel, asked, meshes), `${i}`);
      near(made.volume, solve(fresh(), asked, meshes).mesh.volume, 1e-5, `blend ${blend}, ${i}`);
    }
  }
});
