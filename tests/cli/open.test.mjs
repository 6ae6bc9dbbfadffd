// spineloft open: what was saved is there again, and every project file is a GLB without a fault.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import validator from 'gltf-validator';
import { barFolder, fails, glbJson, readJson, run, works } from '../support/cli.mjs';

/** A folder with the bar as bar.spineloft. */
function savedBar(t) {
  const folder = barFolder(t);
  works('loft', folder.path('bar.png'), '--stroke', folder.path('stroke.json'), '--out', folder.path('bar.spineloft'));
  return folder;
}

async function validates(path) {
  const { issues } = await validator.validateBytes(new Uint8Array(readFileSync(path)));
  assert.equal(issues.numErrors + issues.numWarnings, 0, JSON.stringify(issues.messages));
}

/** The GLB with `change` made to its JSON, lengths set right. */
function withJson(bytes, change) {
  const json = glbJson(bytes);
  change(json);
  const text = Buffer.from(JSON.stringify(json));
  const padded = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, ' ')]);
  const rest = bytes.subarray(20 + bytes.readUInt32LE(12));
  const head = Buffer.alloc(20);
  bytes.copy(head, 0, 0, 20);
  head.writeUInt32LE(20 + padded.length + rest.length, 8);
  head.writeUInt32LE(padded.length, 12);
  return Buffer.concat([head, padded, rest]);
}

test('a saved model opens, its parts are derived again, and saving it once more gives the same bytes', async (t) => {
  const folder = savedBar(t);
  const said = works(
    'open',
    folder.path('bar.spineloft'),
    '--out',
    folder.path('again.spineloft'),
    '--report',
    folder.path('r.json'),
    '--document',
    folder.path('d.json'),
  ).stdout;
  assert.match(said, /^bar: 1 pictures, 1 parts: /);
  assert.deepEqual(readFileSync(folder.path('again.spineloft')), readFileSync(folder.path('bar.spineloft')));
  const report = readJson(folder.path('r.json'));
  assert.deepEqual([report.parts, report.shaped, report.lawful, report.dropped, report.repaired], [1, 1, 1, 0, 0]);
  assert.equal(readJson(folder.path('d.json')).parts[0].name, 'Part 1');
  await validates(folder.path('bar.spineloft'));
});

test('a GLB is a project too, and gives the same OBJ and STL as the picture and its stroke', (t) => {
  const folder = savedBar(t);
  for (const ending of ['glb', 'obj', 'stl']) {
    const [straight, saved] = [folder.path(`straight.${ending}`), folder.path(`saved.${ending}`)];
    works('loft', folder.path('bar.png'), '--stroke', folder.path('stroke.json'), '--out', straight);
    works('open', folder.path('bar.spineloft'), '--out', saved);
    assert.deepEqual(readFileSync(saved), readFileSync(straight));
  }
  works('open', folder.path('straight.glb'));
});

test('projects without a part, and without a picture, are GLBs without a fault', async (t) => {
  const folder = savedBar(t);
  const bar = readFileSync(folder.path('bar.spineloft'));
  const document = (json) => json.extensions.SPINELOFT_project.document;
  const boards = {
    'picture.spineloft': (json) => {
      document(json).parts = [];
    },
    'empty.spineloft': (json) => {
      document(json).parts = [];
      document(json).pictures = [];
    },
  };
  for (const [name, change] of Object.entries(boards)) {
    writeFileSync(folder.path('changed.glb'), withJson(bar, change));
    works('open', folder.path('changed.glb'), '--out', folder.path(name));
    await validates(folder.path(name));
    works('open', folder.path(name));
  }
  assert.deepEqual(Object.keys(glbJson(readFileSync(folder.path('empty.spineloft')))).sort(), [
    'asset',
    'extensions',
    'extensionsUsed',
    'scene',
    'scenes',
  ]);
});

test('what is no project, is cut off or too new is said in one sentence', (t) => {
  const folder = savedBar(t);
  const bar = readFileSync(folder.path('bar.spineloft'));
  writeFileSync(folder.path('cut.spineloft'), bar.subarray(0, bar.length - 100));
  writeFileSync(
    folder.path('new.spineloft'),
    withJson(bar, (json) => {
      json.extensions.SPINELOFT_project.version = 1000;
    }),
  );
  writeFileSync(
    folder.path('other.glb'),
    withJson(bar, (json) => {
      delete json.extensions;
      delete json.extensionsUsed;
    }),
  );
  assert.match(fails(3, 'open', folder.path('cut.spineloft')), /damaged/);
  assert.match(fails(3, 'open', folder.path('new.spineloft')), /newer/);
  assert.match(fails(3, 'open', folder.path('other.glb')), /no model of SpineLoft/);
  assert.match(fails(3, 'open', folder.path('bar.png')), /no model of SpineLoft/);
  for (const name of ['none.spineloft', 'none.glb', 'none.stl', 'none.zip', 'none.png']) {
    writeFileSync(folder.path(name), '');
    assert.match(fails(3, 'open', folder.path(name)), new RegExp(`${name} is empty`));
  }
  // Cut so early that only its first word says what it is.
  writeFileSync(folder.path('stub.glb'), bar.subarray(0, 10));
  assert.match(fails(3, 'open', folder.path('stub.glb')), /damaged/);
  // A model that was saved here, in a form that cannot be edited, is not called a stranger.
  for (const name of ['bar.stl', 'bar.zip', 'bar.3mf']) {
    works('open', folder.path('bar.spineloft'), '--out', folder.path(name));
    assert.match(fails(3, 'open', folder.path(name)), /no model of SpineLoft in that file/);
  }
  assert.match(fails(2, 'open', folder.path('bar.spineloft'), '--out', folder.path('bar.spineloft')), /replace/);
  assert.match(fails(2, 'open', folder.path('bar.spineloft'), '--out', folder.path('x.fbx')), /\.spineloft/);
});

test('solids are written as the parts they are made of, which is said in one sentence', async (t) => {
  const folder = savedBar(t);
  const bar = readFileSync(folder.path('bar.spineloft'));
  writeFileSync(
    folder.path('mug.spineloft'),
    withJson(bar, (json) => {
      const { document } = json.extensions.SPINELOFT_project;
      document.parts.push({ ...document.parts[0], id: 2, name: 'Handle' });
      Object.assign(document, {
        lastPartId: 2,
        lastStepId: 2,
        steps: [
          { id: 1, name: 'Both', operands: [{ part: 1 }, { part: 2 }] },
          { id: 2, name: 'Mug', kind: 'hollow', operands: [{ step: 1 }] },
        ],
      });
    }),
  );
  const out = ['again.glb', 'again.stl', 'again.spineloft'].map(folder.path);
  for (const file of out) {
    const done = run('open', folder.path('mug.spineloft'), '--out', file, '--report', folder.path('r.json'));
    assert.equal(done.status, 0);
    assert.match(done.stderr, /^spineloft: [^\n]*separate parts[^\n]*\(Mug\)\.\n$/);
    assert.match(done.stdout, /1 pictures, 2 parts: /);
  }
  assert.deepEqual([readJson(folder.path('r.json')).parts, readJson(folder.path('r.json')).solids], [2, 2]);
  await validates(out[0]);
  // What it was made of is kept for the page, and nothing is said where no model is written.
  works('open', out[2], '--document', folder.path('d.json'));
  assert.deepEqual(
    readJson(folder.path('d.json')).steps.map(({ name }) => name),
    ['Both', 'Mug'],
  );
  const recipe = run('loft', '--recipe', folder.path('d.json'), folder.path('bar.png'), '--out', folder.path('r.stl'));
  assert.deepEqual([recipe.status, /\(Mug\)\.\n$/.test(recipe.stderr)], [0, true], recipe.stderr);
});

test('a part that lost its picture is left out and said so', (t) => {
  const folder = savedBar(t);
  const bar = readFileSync(folder.path('bar.spineloft'));
  writeFileSync(
    folder.path('lost.spineloft'),
    withJson(bar, (json) => {
      json.extensions.SPINELOFT_project.document.parts[0].recipe.picture = 7;
    }),
  );
  assert.match(
    works('open', folder.path('lost.spineloft')).stdout,
    /1 pictures, 0 parts \(damaged: 1 left out, 0 mended\)/,
  );
});
