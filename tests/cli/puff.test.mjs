// spineloft loft --recipe: puffs, and the bones of their outlines in the report.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { barPng, fails, readJson, works, workFolder } from '../support/cli.mjs';

const arc = (x, y, r, from, to, n = 60) =>
  Array.from({ length: n + 1 }, (_, i) => {
    const a = from + ((to - from) * i) / n;
    return [x + r * Math.cos(a), y + r * Math.sin(a)];
  }).flat();
const circle = (x, y, r) => arc(x, y, r, 0, 2 * Math.PI * (1 - 1 / 120), 119);
const disc = [circle(200, 200, 120)];
const stadium = [
  [...arc(320, 200, 60, -Math.PI / 2, Math.PI / 2), ...arc(80, 200, 60, Math.PI / 2, (3 * Math.PI) / 2)],
];
const ring = [circle(200, 200, 150), circle(200, 200, 70)];

const document = (contours, recipe = {}) => ({
  pictures: [{ id: 1, size: [400, 400] }],
  parts: [{ id: 1, kind: 'puff', recipe: { region: { picture: 1, contours }, ...recipe } }],
});

function write(folder, json) {
  writeFileSync(folder.path('puff.json'), JSON.stringify(json));
  return folder.path('puff.json');
}
function reported(folder, contours, recipe) {
  const file = write(folder, document(contours, recipe));
  works('loft', '--recipe', file, '--report', folder.path('report.json'));
  return readJson(folder.path('report.json'));
}

test('the report of a puff says where the bones of its outline are', (t) => {
  const folder = workFolder(t);
  const { bones } = reported(folder, stadium);
  assert.deepEqual([bones.ends, bones.forks, bones.rings, bones.branches.length], [2, 0, 0, 1]);
  assert.ok(Math.abs(bones.length - 240) < 6, `${bones.length}`);
  for (let i = 0; i < bones.branches[0].length; i += 3) {
    const [x, y, half] = bones.branches[0].slice(i, i + 3);
    assert.ok(x > 77 && x < 323 && Math.abs(y - 200) < 1 && Math.abs(half - 60) < 1, `${x} ${y} ${half}`);
  }
  assert.deepEqual([reported(folder, disc).bones.ends, reported(folder, ring).bones.rings], [0, 1]);
  const two = reported(folder, [...disc.map((line) => line.map((v) => v / 2)), circle(330, 330, 40)]).bones;
  assert.equal(two.branches.length, 2, 'a bone for each piece');
});

test('outlines written as pairs of numbers are named', (t) => {
  const folder = workFolder(t);
  const file = write(folder, {
    kind: 'puff',
    recipe: {
      region: {
        contours: [
          [
            [0, 0],
            [90, 0],
            [90, 90],
          ],
        ],
      },
    },
  });
  writeFileSync(folder.path('paper.png'), barPng());
  const said = fails(3, 'loft', folder.path('paper.png'), '--recipe', file, '--report', folder.path('report.json'));
  assert.match(said, /recipe\.region\.contours is no list of lists x, y, x, y/);
});
