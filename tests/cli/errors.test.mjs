// What the command line refuses: the exit code, one sentence, and nothing left behind.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { chmodSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { PNG } from 'pngjs';
import { barFolder, barPng, barStroke, fails, program, run } from '../support/cli.mjs';

const kUsage = 2;
const kInput = 3;

test('control characters in names reach the terminal as text', (t) => {
  const folder = barFolder(t);
  const { stderr } = run(
    'loft',
    folder.path('a\u001b[2Jb\u0007\u009bc\u007fé.png'),
    '--stroke',
    folder.path('stroke.json'),
  );
  assert.match(stderr, /a\\x1b\[2Jb\\x07\\x9bc\\x7fé\.png/);
});

test('a signal while files are written ends the program and leaves them as before, or all of them new', async (t) => {
  const folder = barFolder(t);
  const outputs = ['a.glb', 'b.json', 'c.png'].map((name) => folder.path(name));
  const words = ['loft', folder.path('bar.png'), '--stroke', folder.path('stroke.json'), '--out', outputs[0]];
  words.push('--report', outputs[1], '--mask', outputs[2]);
  const begun = Date.now();
  assert.equal(run(...words).status, 0);
  const lasts = Date.now() - begun;
  let killed = 0;
  for (let i = 0; i < 24; i += 1) {
    for (const file of outputs) writeFileSync(file, 'old');
    const child = spawn(program, words, { stdio: 'ignore' });
    const ended = new Promise((resolve) => child.on('exit', (code, signal) => resolve(signal)));
    // Most of them near the end, where it writes.
    setTimeout(() => child.kill(i % 2 ? 'SIGTERM' : 'SIGINT'), lasts * (0.5 + i / 40));
    if ((await ended) !== null) killed += 1;
    const old = outputs.map((file) => readFileSync(file, 'latin1') === 'old');
    assert.ok(
      old.every((is) => is === old[0]),
      String(old),
    );
    assert.deepEqual(
      folder.list().filter((name) => name.startsWith('.')),
      [],
    );
  }
  assert.ok(killed > 0, 'none of them was in time');
});

test('wrong usage ends with 2 and says what is wrong', (t) => {
  const folder = barFolder(t);
  const picture = folder.path('bar.png');
  const stroke = ['--stroke', folder.path('stroke.json')];
  const wrong = [
    [[], /loft, make, open, share, edges, bench or ode/],
    [['carve'], /carve/],
    [['--version', 'loft'], /--version/],
    [['loft'], /picture/],
    [['loft', picture], /--stroke/],
    [['loft', picture, '--stroke'], /--stroke needs a value/],
    [['loft', picture, '--stroke='], /--stroke needs a value/],
    [['loft', picture, 'other.png', ...stroke], /other\.png/],
    [['loft', picture, ...stroke, ...stroke], /twice/],
    [['loft', picture, ...stroke, '--colour', 'red'], /--colour/],
    [['loft', picture, ...stroke, '--section', 'banana'], /banana.*rounded-square/],
    [['loft', picture, ...stroke, '--caps', 'hat'], /hat.*pointed/],
    [['loft', picture, ...stroke, '--out', folder.path('bar.fbx')], /\.glb, \.obj, \.zip, \.stl, \.3mf or \.spineloft/],
    [['loft', picture, ...stroke, '--out', folder.path('glb')], /\.glb, \.obj, \.zip, \.stl, \.3mf or \.spineloft/],
    [['loft', picture, ...stroke, '--out', folder.path('a.obj'), '--obj-space', 'moon'], /moon.*image, world/],
    [['loft', picture, ...stroke, '--out', folder.path('a.stl'), '--obj-space', 'image'], /\.obj/],
    [['loft', picture, ...stroke, '--report', folder.path('x.json'), '--ribs', folder.path('x.json')], /same name/],
    [
      ['loft', picture, ...stroke, '--mask', folder.path('../' + folder.folder.split('/').at(-1) + '/bar.png')],
      /replace an input/,
    ],
    ...['0', '-5', '10001', 'tall', '1e9', 'nan', '10mm', ''].map((height) => [
      ['loft', picture, ...stroke, '--height-mm', height],
      /height/,
    ]),
    [['edges', picture], /--out/],
    [['edges', '--out', folder.path('e.png')], /IMAGE is required/],
    [['edges', picture, '--out', folder.path('e.jpg')], /\.png/],
    [['loft', picture, ...stroke, '--mask', folder.path('m.jpg')], /m\.jpg must end in \.png/],
    [['loft', picture, ...stroke, '--mask', folder.path('m')], /must end in \.png/],
    [['loft', picture, ...stroke, '--ribs', folder.path('ribs.csv')], /ribs\.csv must end in \.json/],
    [['loft', picture, ...stroke, '--report', folder.path('r.txt')], /\.json/],
    [['open', folder.path('bar.glb'), '--document', folder.path('d.png')], /\.json/],
    [['open', folder.path('bar.glb'), '--report', folder.path('d.png')], /\.json/],
    [['bench', folder.folder, '--json', folder.path('b.md')], /\.json/],
    [['bench'], /DATA_DIR is required/],
    ...['0', '1.5', '65', 'x'].map((jobs) => [['bench', folder.folder, '--jobs', jobs], /jobs/]),
  ];
  for (const [args, words] of wrong) assert.match(fails(kUsage, ...args), words);
  assert.deepEqual(folder.list(), ['bar.png', 'stroke.json']);
});

/** Fails with 3 for this picture and leaves the folder as it was. */
function refusesPicture(folder, bytes, words) {
  writeFileSync(folder.path('bad'), bytes);
  const before = folder.list();
  const outputs = ['--out', folder.path('a.glb'), '--mask', folder.path('a.png'), '--ribs', folder.path('a.json')];
  assert.match(fails(kInput, 'loft', folder.path('bad'), '--stroke', folder.path('stroke.json'), ...outputs), words);
  assert.match(fails(kInput, 'edges', folder.path('bad'), '--out', folder.path('e.png')), words);
  assert.deepEqual(folder.list(), before);
}

function pngOf(width, height) {
  const png = new PNG({ width, height });
  png.data.fill(200);
  return PNG.sync.write(png);
}

test('bad pictures end with 3 and say which way they are bad', (t) => {
  const folder = barFolder(t);
  refusesPicture(folder, '', /empty/);
  refusesPicture(folder, 'Dear Sir or Madam', /not a picture/);
  const good = barPng();
  for (const share of [0.01, 0.3, 0.9, 0.999]) {
    refusesPicture(folder, good.subarray(0, Math.ceil(share * good.length)), /cut off/);
  }
  refusesPicture(folder, pngOf(1, 1), /too small/);
  refusesPicture(folder, pngOf(20000, 1), /too small/);
  const huge = Buffer.from(good);
  huge.writeUInt32BE(64250, 16);
  huge.writeUInt32BE(64250, 20);
  refusesPicture(folder, huge, /too large/);
});

test('bad strokes end with 3 and say which way they are bad', (t) => {
  const folder = barFolder(t);
  const loop = Array.from({ length: 80 }, (_, i) => [120 + 60 * Math.sin(i / 8), 160 + 60 * Math.sin(i / 16)]);
  const bad = [
    ['', /empty/],
    ['{', /JSON/],
    ['"line"', /JSON/],
    ['[1, 2, 3]', /JSON.*point 1/],
    ['[[1, 2], [3]]', /JSON.*point 2/],
    ['[[1, 2], ["3", 4]]', /JSON.*point 2/],
    ['{"spines": {}}', /JSON/],
    ['{"spines": [[1, 2]]}', /JSON/],
    ['[[1, 2], [NaN, 3]]', /JSON/],
    ['[]', /too short/],
    ['[[100, 100]]', /too short/],
    ['[[100, 100], [100, 100]]', /too short/],
    ['[[100, 100], [null, 120]]', /without a place.*point 2/],
    ['[[-500, -500], [-400, -500]]', /outside/],
    [JSON.stringify(loop), /crosses itself/],
  ];
  for (const [text, words] of bad) {
    writeFileSync(folder.path('bad.json'), text);
    const before = folder.list();
    const sentence = fails(
      kInput,
      'loft',
      folder.path('bar.png'),
      '--stroke',
      folder.path('bad.json'),
      '--out',
      folder.path('a.glb'),
    );
    assert.match(sentence, words, text);
    assert.match(sentence, /bad\.json/);
    assert.deepEqual(folder.list(), before);
  }
  writeFileSync(folder.path('names.json'), JSON.stringify({ spines: { careful: barStroke, sloppy: barStroke } }));
  const named = (file) =>
    fails(kInput, 'loft', folder.path('bar.png'), '--stroke', folder.path(file), '--stroke-name', 'tidy');
  assert.match(named('names.json'), /tidy.*careful, sloppy/);
  assert.match(named('stroke.json'), /no named strokes/);
});

test('files that are missing or are folders end with 3 and are named', (t) => {
  const folder = barFolder(t);
  mkdirSync(folder.path('folder'));
  const stroke = folder.path('stroke.json');
  for (const missing of ['none.png', 'folder']) {
    assert.match(fails(kInput, 'loft', folder.path(missing), '--stroke', stroke), new RegExp(missing));
    assert.match(fails(kInput, 'loft', folder.path('bar.png'), '--stroke', folder.path(missing)), new RegExp(missing));
    assert.match(fails(kInput, 'bench', folder.path(missing)), new RegExp(missing));
  }
});

test('when one output cannot be written none is, and what was there before is untouched', (t) => {
  const folder = barFolder(t);
  writeFileSync(folder.path('a.stl'), 'old model');
  writeFileSync(folder.path('a.json'), 'old ribs');
  for (const name of ['taken', 'taken.png']) mkdirSync(folder.path(name));
  const before = folder.list();
  for (const unwritable of [folder.path('no/such/folder/m'), folder.path('taken')]) {
    for (const order of [
      ['--mask', `${unwritable}.png`, '--report', folder.path('new')],
      ['--report', unwritable, '--mask', folder.path('new.png')],
    ]) {
      const sentence = fails(
        kInput,
        'loft',
        folder.path('bar.png'),
        '--stroke',
        folder.path('stroke.json'),
        '--out',
        folder.path('a.stl'),
        '--ribs',
        folder.path('a.json'),
        ...order,
      );
      assert.match(sentence, /cannot be written/);
      assert.ok(sentence.includes(unwritable));
      assert.deepEqual(folder.list(), before);
      assert.equal(readFileSync(folder.path('a.stl'), 'utf8'), 'old model');
      assert.equal(readFileSync(folder.path('a.json'), 'utf8'), 'old ribs');
    }
  }
});

test(
  'a folder without write permission is left alone',
  { skip: process.getuid?.() === 0 && 'root may write anywhere' },
  (t) => {
    const folder = barFolder(t);
    mkdirSync(folder.path('closed'));
    chmodSync(folder.path('closed'), 0o555);
    fails(kInput, 'edges', folder.path('bar.png'), '--out', folder.path('closed/e.png'));
  },
);
