// spineloft ode: closed forms beside finite differences.
import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import test from 'node:test';
import { fails, workFolder, works } from '../support/cli.mjs';

test('closed forms and finite differences differ four times less on twice as many nodes', (t) => {
  const folder = workFolder(t);
  const file = folder.path('case.json');
  const largest = (given) => {
    writeFileSync(file, JSON.stringify(given));
    return JSON.parse(works('ode', '--case', file).stdout);
  };
  for (const given of [
    { ends: [0, 1], slopes: [2, -1], lambda: 16 },
    {
      ring: [
        [0, 1],
        [0.25, -1],
        [0.5, 0.5],
        [0.75, 0],
      ],
      lambda: 8,
    },
  ]) {
    const [coarse, middle, fine] = [64, 128, 256].map((n) => largest({ ...given, n }));
    assert.equal(fine.closed.length, fine.differences.length);
    assert.ok(fine.largest <= 1e-3 && fine.largest > 1e-9, `${fine.largest}`);
    for (const ratio of [coarse.largest / middle.largest, middle.largest / fine.largest]) {
      assert.ok(ratio >= 3.4 && ratio <= 4.2, `${ratio}`);
    }
  }
});

test('a case that is none is refused with what is wrong', (t) => {
  const folder = workFolder(t);
  const file = folder.path('case.json');
  const refused = (given, words) => {
    writeFileSync(file, JSON.stringify(given));
    assert.match(fails(3, 'ode', '--case', file), words);
  };
  const ends = { ends: [0, 1], slopes: [0, 0] };
  refused([], /no object/);
  refused({ ...ends, lambda: -1, n: 64 }, /lambda/);
  refused({ ...ends, lambda: 1, n: 2 }, /n is 5 to 4096/);
  refused({ ends: [0], slopes: [0, 0], lambda: 1, n: 64 }, /ends and slopes/);
  refused({ ring: [[0.3, 1]], lambda: 1, n: 64 }, /multiples/);
  refused({ ring: [], lambda: 1, n: 64 }, /at least one node/);
});
