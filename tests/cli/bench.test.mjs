// spineloft bench: a data folder made on the spot, and the scorer of the real one as a second opinion.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { PNG } from 'pngjs';
import { bar, barStroke, dataFolder, fails, readJson, readPng, workFolder, works, writeCase } from '../support/cli.mjs';

test('every case and stroke is scored, and the means are of the rows', (t) => {
  const folder = workFolder(t);
  writeCase(folder, 'one');
  writeCase(folder, 'two', { category: 'other' });
  mkdirSync(folder.path('not-a-case'));
  const { stdout } = works(
    'bench',
    folder.folder,
    '--json',
    folder.path('bench.json'),
    '--overlays',
    folder.path('seen/here'),
    '--jobs',
    '2',
  );
  const { cases, summary } = readJson(folder.path('bench.json'));
  assert.deepEqual(
    cases.map(({ id, stroke }) => `${id} ${stroke}`),
    ['one careful', 'one sloppy', 'two careful', 'two sloppy'],
  );
  for (const row of cases) {
    assert.ok(row.iou > 0.9 && row.iou_body > 0.95, JSON.stringify(row));
    assert.ok(row.rib_mean_pct < 5 && row.rib_within_tol > 0.6, JSON.stringify(row));
    assert.equal(row.mesh_lawful, 1);
    assert.equal(row.ends_edge + row.ends_bridged + row.ends_guessed, 2 * row.ribs);
    assert.ok(row.edges_ms > 0 && row.ribs_ms > 0 && row.loft_ms > 0);
    const overlay = readPng(folder.path(`seen/here/${row.id}.${row.stroke}.png`));
    assert.deepEqual([overlay.width, overlay.height], [bar.width, bar.height]);
    assert.ok(stdout.includes(`${row.id} ${row.stroke}`));
  }
  assert.equal(cases[0].iou, cases[2].iou, 'equal cases score alike, whichever thread ran them');
  assert.deepEqual(
    summary.map(({ name }) => name),
    ['all careful', 'all sloppy', 'made careful', 'made sloppy', 'other careful', 'other sloppy'],
  );
  const sloppy = cases.filter(({ stroke }) => stroke === 'sloppy');
  for (const key of ['iou', 'iou_body', 'rib_mean_pct', 'rib_p95_pct', 'rib_within_tol']) {
    const mean = sloppy.reduce((sum, row) => sum + row[key], 0) / sloppy.length;
    assert.ok(Math.abs(summary[1][key] - mean) < 1e-9, key);
  }
});

test('where results cannot be written is said before anything is done', (t) => {
  const folder = workFolder(t);
  writeCase(folder, 'one');
  const outputs = ['--json', folder.path('no/such/file'), '--overlays', folder.path('seen')];
  assert.match(fails(3, 'bench', folder.folder, ...outputs), /no\/such\/file/);
  assert.ok(!existsSync(folder.path('seen')));
});

test('means are given for all cases that are hard in one way, and a case may be hard in several', (t) => {
  const folder = workFolder(t);
  writeCase(folder, 'clean', { difficulty: { missing_boundary_pct: 0 } });
  writeCase(folder, 'gaps', { difficulty: { missing_boundary_pct: 25, noise_sigma: 9 } });
  writeCase(folder, 'worse', {
    difficulty: { missing_boundary_pct: 50, occlusion_pct: 20, no_edge_pct: 60, inner_edges_per_1000px: 120 },
  });
  writeCase(folder, 'unknown');
  works('bench', folder.folder, '--json', folder.path('bench.json'));
  const { cases, summary } = readJson(folder.path('bench.json'));
  const hard = Object.fromEntries(cases.map(({ id, difficulty }) => [id, difficulty]));
  assert.deepEqual(hard, {
    clean: ['outline complete'],
    gaps: ['outline partly erased', 'noise'],
    unknown: [],
    worse: ['outline half erased', 'outline faint', 'partly hidden', 'edges inside'],
  });
  for (const name of new Set(Object.values(hard).flat())) {
    const group = summary.find((each) => each.name === `${name}, careful`),
      rows = cases.filter(({ stroke, difficulty }) => stroke === 'careful' && difficulty.includes(name));
    assert.equal(group.cases, rows.length, name);
    assert.ok(Math.abs(group.iou - rows.reduce((sum, { iou }) => sum + iou, 0) / rows.length) < 1e-9, name);
  }
});

test('a single case folder is a data folder too, and a part that cannot be made counts as nothing', (t) => {
  const folder = workFolder(t);
  writeCase(folder, 'one', {
    spines: {
      outside: [
        [-90, -90],
        [-50, -90],
      ],
      careful: barStroke,
    },
  });
  works('bench', folder.path('one'), '--json', folder.path('bench.json'));
  const [outside, careful] = readJson(folder.path('bench.json')).cases;
  assert.equal(outside.failure, 'StrokeOutsidePicture');
  assert.equal(outside.iou, 0);
  assert.equal(careful.failure, undefined);
});

test('a damaged data folder ends with 3 and leaves no report', (t) => {
  const folder = workFolder(t);
  writeCase(folder, 'one');
  const original = readFileSync(folder.path('one/case.json'), 'utf8');
  const bench = () => fails(3, 'bench', folder.folder, '--json', folder.path('bench.json'));
  for (const text of [
    '{',
    '[]',
    '{"id": "one"}',
    original.replace('"axis"', '"axes"'),
    original.replace('mask.png', 'gone.png'),
  ]) {
    writeFileSync(folder.path('one/case.json'), text);
    assert.match(bench(), /one/);
  }
  writeFileSync(folder.path('one/case.json'), original);
  writeFileSync(folder.path('one/mask.png'), PNG.sync.write(new PNG({ width: 20, height: 20 })));
  assert.match(bench(), /not as large/);
  assert.ok(!existsSync(folder.path('bench.json')));
});

const scorer = dataFolder && [join(dataFolder, 'score.py'), join(dataFolder, '../score.py')].find(existsSync);
const python = ['python3', '/usr/bin/python3'].find(
  (name) => spawnSync(name, ['-c', 'import cv2, numpy']).status === 0,
);
const noScorer = !scorer ? 'the data folder is not here' : !python ? 'python3 with numpy and cv2 is not here' : false;

test('the scores are those of the data folder’s own scorer', { skip: noScorer }, (t) => {
  // One with do-not-care, one with open ends and a thin part, one where much goes wrong.
  const chosen = ['photo_swan_neck', 'proc_very_thin_g25', 'sketch_bottle'];
  const folder = workFolder(t);
  mkdirSync(folder.path('data'));
  for (const id of chosen) symlinkSync(join(dataFolder, id), folder.path(`data/${id}`));
  works('bench', folder.path('data'), '--json', folder.path('bench.json'));
  for (const row of readJson(folder.path('bench.json')).cases) {
    const source = readJson(join(dataFolder, row.id, 'case.json'));
    const files = ['--mask', folder.path('mask.png'), '--ribs', folder.path('ribs.json')];
    works(
      'loft',
      join(dataFolder, row.id, source.image),
      '--stroke',
      join(dataFolder, row.id, 'case.json'),
      '--stroke-name',
      row.stroke,
      ...files,
    );
    const done = spawnSync(python, [scorer, join(dataFolder, row.id), ...files, '--spine', row.stroke], {
      encoding: 'utf8',
    });
    assert.equal(done.status, 0, done.stderr);
    const wanted = JSON.parse(done.stdout);
    const pairs = {
      iou: wanted.iou,
      iou_body: wanted.iou_body,
      precision: wanted.precision,
      recall: wanted.recall,
      rib_mean_pct: wanted.rib.mean_pct,
      rib_p95_pct: wanted.rib.p95_pct,
      rib_mean_px: wanted.rib.mean_px,
      rib_within_tol: wanted.rib.within_tol,
      rib_ends_judged: wanted.rib.n,
    };
    for (const [key, value] of Object.entries(pairs)) {
      const near = 1e-3 * Math.max(1, Math.abs(value));
      assert.ok(Math.abs(row[key] - value) <= near, `${row.id} ${row.stroke} ${key}: ${row[key]}, scorer ${value}`);
    }
  }
});
