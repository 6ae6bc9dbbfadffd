// The same picture and stroke give the same ribs natively and as WebAssembly, on every public case.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { test } from 'node:test';
import { dataFolder } from '../support/cli.mjs';

const build = fileURLToPath(new URL('../../build/', import.meta.url));
const native = join(build, 'native-release/spineloft_bench');
const wasm = join(build, 'wasm-release/spineloft_bench_single.js');
const reason = !dataFolder
  ? 'the data folder is not here'
  : ![native, wasm].every(existsSync) && 'spineloft_bench is not built natively and as WebAssembly';

/** Rib ends further apart than this are different, in picture pixels. */
const kSame = 0.5;
/** Edge detection rounds differently in the two builds; where two places are equally good an end may jump. */
const kShareThatMayDiffer = 0.005;

function ribsOf(command, args) {
  const done = spawnSync(command, args, { encoding: 'utf8', maxBuffer: 1 << 26 });
  assert.equal(done.status, 0, done.stderr);
  return done.stdout
    .trim()
    .split('\n')
    .map((line) => JSON.parse(line).ribs);
}

test('native and WebAssembly ribs agree on every case and stroke', { skip: reason, timeout: 600000 }, (t) => {
  const cases = readdirSync(dataFolder).filter((name) => existsSync(join(dataFolder, name, 'case.json')));
  assert.ok(cases.length > 0);
  let ends = 0;
  let apart = 0;
  for (const name of cases) {
    const here = ribsOf(native, ['--ribs', join(dataFolder, name)]);
    const there = ribsOf(process.execPath, [wasm, '--ribs', join(dataFolder, name)]);
    assert.deepEqual(
      there.map((ribs) => ribs.length),
      here.map((ribs) => ribs.length),
      name,
    );
    here.forEach((ribs, stroke) =>
      ribs.forEach((rib, i) => {
        for (const side of ['left', 'right']) {
          const [a, b] = [rib[side], there[stroke][i][side]];
          ends++;
          apart += Math.hypot(a[0] - b[0], a[1] - b[1]) > kSame;
        }
      }),
    );
  }
  t.diagnostic(`${apart} of ${ends} rib ends differ by more than ${kSame} px`);
  assert.ok(apart <= kShareThatMayDiffer * ends, `${apart} of ${ends} rib ends differ by more than ${kSame} px`);
});
