// spineloft_accuracy: what it adds to `spineloft bench`, on a data folder made on the spot.
import assert from 'node:assert/strict';
import { dirname, join } from 'node:path';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { program, readJson, runProgram, workFolder, works, writeCase } from '../support/cli.mjs';

function accuracy(...args) {
  return runProgram(join(dirname(program), 'spineloft_accuracy'), args);
}

/** The rows of a run, without what a clock says. */
function rowsOf(path) {
  return readJson(path).cases.map((row) =>
    Object.fromEntries(Object.entries(row).filter(([name]) => !name.endsWith('_ms'))),
  );
}

test('with nothing asked for it scores as bench does, and live strokes are held against whole ones', (t) => {
  const folder = workFolder(t);
  writeCase(folder, 'one');
  works('bench', folder.folder, '--json', folder.path('bench.json'));
  assert.equal(accuracy(folder.folder, '--json', folder.path('plain.json')).status, 0);
  assert.deepEqual(rowsOf(folder.path('plain.json')), rowsOf(folder.path('bench.json')));
  assert.equal(accuracy(folder.folder, '--live', '20', '--json', folder.path('live.json')).status, 0);
  const { cases, summary } = readJson(folder.path('live.json'));
  for (const row of cases)
    assert.ok(row.live_up_pct < 3 && row.live_jumps < 0.3 && row.live_followed > 0.3, JSON.stringify(row));
  assert.equal(summary.find(({ name }) => name === 'all careful').live_up_pct, cases[0].live_up_pct);
});

test('other strokes, erased outlines and variations change the rows; the ablation has a line for each variation', (t) => {
  const folder = workFolder(t);
  writeCase(folder, 'one');
  accuracy(folder.folder, '--json', folder.path('plain.json'));
  const plain = rowsOf(folder.path('plain.json'));
  for (const words of [
    ['--redraw', '3'],
    ['--erase', '0.5'],
    ['--overshoot', '1'],
    ['--variation', 'd-inf-separate'],
  ]) {
    assert.equal(accuracy(folder.folder, ...words, '--json', folder.path('other.json')).status, 0);
    assert.notDeepEqual(rowsOf(folder.path('other.json')), plain, words[0]);
  }
  const outputs = ['--json', folder.path('all.json'), '--ablation', folder.path('all.md')];
  assert.equal(accuracy(folder.folder, ...outputs).status, 0);
  const { ablation } = readJson(folder.path('all.json'));
  assert.equal(ablation[0].name, 'as it is');
  assert.equal(ablation[0]['iou_body careful'], plain[0].iou_body);
  const [, keys] = /--variation TEXT:\{([^}]+)\}/.exec(accuracy('--help').stdout);
  assert.equal(ablation.length, keys.split(',').length);
  assert.equal(readFileSync(folder.path('all.md'), 'utf8').trim().split('\n').length, ablation.length + 2);
});

test('states of ends: shares sum to one, and on an easy picture nearly all are on an edge and right', (t) => {
  const folder = workFolder(t);
  writeCase(folder, 'one');
  const outputs = ['--json', folder.path('states.json'), '--states', folder.path('states.md')];
  assert.equal(accuracy(folder.folder, ...outputs).status, 0);
  const { end_states: lines } = readJson(folder.path('states.json'));
  const share = (names) =>
    lines.filter(({ name }) => names.test(name)).reduce((sum, one) => sum + one['share of the ends'], 0);
  assert.ok(Math.abs(share(/^support/) - 1) < 1e-9 && Math.abs(share(/edge|bridged|guessed/) - 1) < 1e-9);
  const edge = lines.find(({ name }) => name === 'on an edge');
  assert.ok(edge['share of the ends'] > 0.8 && edge.is > 0.9, JSON.stringify(edge));
  assert.equal(readFileSync(folder.path('states.md'), 'utf8').trim().split('\n').length, lines.length + 2);
});

test('wrong words end with 2, bad input with 3, and nothing is written', (t) => {
  const folder = workFolder(t);
  writeCase(folder, 'one');
  for (const words of [
    [],
    [folder.folder, '--variation', 'banana'],
    [folder.folder, '--erase', '2'],
    [folder.folder, '--live', '5'],
  ]) {
    const done = accuracy(...words);
    assert.equal(done.status, 2, words.join(' '));
    assert.notEqual(done.stderr, '');
  }
  assert.equal(accuracy(folder.path('nowhere')).status, 3);
  const said = accuracy(folder.folder, '--leave-one-out', folder.path('no/such/file.md'));
  assert.equal(said.status, 3);
  assert.match(said.stderr, /no\/such\/file/);
  assert.deepEqual(folder.list(), ['one']);
});
