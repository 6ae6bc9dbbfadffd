// The solver of quadratic programs against another one (npm quadprog), natively and as WebAssembly.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { test } from 'node:test';
import { solveQP } from 'quadprog';

const build = fileURLToPath(new URL('../../build/', import.meta.url));
const native = join(build, 'native-release/spineloft_bench');
const wasm = join(build, 'wasm-release/spineloft_bench_single.js');
const reason = ![native, wasm].every(existsSync) && 'spineloft_bench is not built natively and as WebAssembly';

const kPrograms = 1000;

function programs(command, args) {
  const done = spawnSync(command, [...args, '--programs', String(kPrograms)], { encoding: 'utf8', maxBuffer: 1 << 28 });
  assert.equal(done.status, 0, done.stderr);
  return done.stdout
    .trim()
    .split('\n')
    .map((line) => JSON.parse(line));
}

const dot = (a, b) => a.reduce((sum, value, i) => sum + value * b[i], 0);

/** quadprog counts from 1, and wants a column a row. */
const fromOne = (list) => [0, ...list];

/** The least value of ½ zᵀHz + hᵀz that quadprog finds. */
function otherOptimum({ energy, linear, rows }) {
  const { value, message } = solveQP(
    fromOne(energy.map(fromOne)),
    fromOne(linear.map((h) => -h)),
    fromOne(linear.map((_, i) => fromOne(rows.map(({ row }) => row[i])))),
    fromOne(rows.map(({ least }) => least)),
  );
  assert.equal(message, '');
  return value[1];
}

test(
  `${kPrograms} random programs have the optimum of another solver, natively and as WebAssembly`,
  { skip: reason },
  (t) => {
    const here = programs(native, []);
    const there = programs(process.execPath, [wasm]);
    assert.equal(here.length, kPrograms);
    let off = 0;
    let broken = 0;
    let apart = 0;
    here.forEach((program, i) => {
      const { energy, linear, rows, z } = program;
      assert.deepEqual(there[i].linear, linear);
      const value =
        0.5 *
          dot(
            z,
            energy.map((row) => dot(row, z)),
          ) +
        dot(linear, z);
      off = Math.max(off, Math.abs(value - otherOptimum(program)));
      broken = Math.max(broken, ...rows.map(({ row, least }) => least - dot(row, z)));
      apart = Math.max(apart, ...z.map((coordinate, k) => Math.abs(coordinate - there[i].z[k])));
    });
    t.diagnostic(`objectives at most ${off} apart, rows broken by at most ${broken}, builds ${apart} apart`);
    assert.ok(off <= 1e-6, `objectives are ${off} apart`);
    assert.ok(broken <= 1e-7, `a row is broken by ${broken}`);
    assert.ok(apart <= 1e-9, `the builds are ${apart} apart`);
  },
);
