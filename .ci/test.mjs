// npm test: set-up, then every check and test program of the project. The last line is the sum of all runners.
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { houseErrors, houseFiles } from './arrows.mjs';
import { buildSite } from './build.mjs';
import { buildTargets, presetDir } from './lib/cmake.mjs';
import { doctestCounts, doctestTotal, nodeTestCounts, stretchCounts, sumCounts, testStretches } from './lib/counts.mjs';
import { buildDir, dataFolder, root } from './lib/paths.mjs';
import { duration, mainProgram, output, run, say, Stop } from './lib/run.mjs';
import { setup } from './setup.mjs';

const kMinutes = 60000;

async function arrows() {
  const errors = houseErrors(houseFiles());
  for (const error of errors) say(error);
  return { passed: errors.length ? 0 : 1, failed: errors.length ? 1 : 0, note: '' };
}

async function types() {
  const tsc = join(root, 'node_modules/typescript/bin/tsc');
  const done = await run('tsc', process.execPath, [tsc, '--noEmit', '-p', 'web/shell'], {
    cwd: root,
    show: true,
    allowFailure: true,
  });
  return { passed: done.problem ? 0 : 1, failed: done.problem ? 1 : 0, note: '' };
}

/**
 * Runs a doctest program over its test cases in stretches, as many side by side as there are processors. A stretch
 * that breaks off is a failure by itself.
 */
async function doctest(preset, command, args, env = {}) {
  const options = {
    cwd: root,
    env: { ...(dataFolder ? { SPINELOFT_DATA: dataFolder } : {}), ...env },
    allowFailure: true,
    log: `${preset}-tests`,
    timeout: 20 * kMinutes,
  };
  const listed = await run(
    `the list of tests of ${preset}`,
    command,
    [...args, '--count', '--no-colors', '--no-version'],
    options,
  );
  const total = doctestTotal(listed.text);
  if (!total) return doctestCounts(listed);
  const stretches = testStretches(total, 3 * availableParallelism());
  const results = [];
  const work = async () => {
    for (let next = stretches.shift(); next; next = stretches.shift()) {
      const { first, last } = next;
      const label = `the tests ${first} to ${last} of ${preset}`;
      const done = await run(
        label,
        command,
        [...args, `--first=${first}`, `--last=${last}`, '--no-colors', '--no-version'],
        { ...options, show: true },
      );
      const counts = stretchCounts(done, last - first + 1);
      if (done.status === null) counts.note = `${label} were ${done.problem}`;
      results.push(counts);
    }
  };
  await Promise.all(Array.from({ length: availableParallelism() }, work));
  return sumCounts(results);
}

async function native() {
  await buildTargets('native-release', ['spineloft_tests', 'spineloft', 'spineloft_bench']);
  return doctest('native-release', join(presetDir('native-release'), 'spineloft_tests'), []);
}

async function asan() {
  await buildTargets('native-asan', ['spineloft_tests']);
  return doctest('native-asan', join(presetDir('native-asan'), 'spineloft_tests'), [], {
    ASAN_OPTIONS: 'detect_stack_use_after_return=1:strict_string_checks=1',
    UBSAN_OPTIONS: 'print_stacktrace=1:halt_on_error=1',
    ASAN_SYMBOLIZER_PATH: output('sh', ['-c', 'command -v llvm-symbolizer-19']) ?? '',
  });
}

async function wasm(preset) {
  await buildTargets(preset, ['spineloft_tests', 'spineloft_bench']);
  return doctest(preset, process.execPath, [join(presetDir(preset), 'spineloft_tests.js')]);
}

/** Runs `folders`' *.mjs files with node:test; the readable report goes to the screen, the TAP one is counted. */
async function nodeTests(name, folders, concurrency) {
  const files = folders
    .filter((folder) => existsSync(join(root, folder)))
    .flatMap((folder) => readdirSync(join(root, folder)).map((file) => join(folder, file)))
    .filter((file) => file.endsWith('.mjs'))
    .sort();
  if (!files.length) return { passed: 0, failed: 1, note: `no test file in ${folders.join(', ')}` };
  const tap = join(buildDir, 'logs', `${name}.tap`);
  mkdirSync(join(buildDir, 'logs'), { recursive: true });
  rmSync(tap, { force: true });
  const args = [
    '--test',
    `--test-concurrency=${concurrency}`,
    '--test-reporter=spec',
    '--test-reporter-destination=stdout',
    '--test-reporter=tap',
    `--test-reporter-destination=${tap}`,
    ...files,
  ];
  const env = { SPINELOFT_CLI: join(presetDir('native-release'), 'spineloft'), NODE_OPTIONS: '' };
  const options = { cwd: root, env, show: true, allowFailure: true, log: `${name}-tests`, timeout: 50 * kMinutes };
  const done = await run(`the ${name} tests`, process.execPath, args, options);
  return nodeTestCounts({ text: existsSync(tap) ? readFileSync(tap, 'utf8') : '', status: done.status });
}

async function node() {
  await buildTargets('native-release', ['spineloft', 'spineloft_accuracy']);
  return nodeTests('node', ['.ci/tests', 'tests/cli'], 2);
}

async function browser() {
  await buildSite();
  return nodeTests('browser', ['tests/browser'], 1);
}

const kStages = {
  arrows: { title: 'House rules: include arrows, file lengths', needs: [], work: arrows },
  types: { title: 'TypeScript types', needs: ['node'], work: types },
  native: { title: 'Engine, native and optimised', needs: ['native'], work: native },
  asan: { title: 'Engine under AddressSanitizer and UndefinedBehaviorSanitizer', needs: ['native'], work: asan },
  wasm: { title: 'Engine as WebAssembly with threads, under Node', needs: ['wasm'], work: () => wasm('wasm-release') },
  'wasm-st': {
    title: 'Engine as WebAssembly, single thread, under Node',
    needs: ['wasm'],
    work: () => wasm('wasm-release-st'),
  },
  node: { title: 'Command line and scripts', needs: ['native', 'node', 'readers'], work: node },
  browser: {
    title: 'The page in headless Chromium',
    needs: ['native', 'wasm', 'browser', 'node', 'readers'],
    work: browser,
  },
};

function chosenStages() {
  let only;
  try {
    only = parseArgs({ options: { only: { type: 'string' } } }).values.only;
  } catch (error) {
    throw new Stop(`${error.message}\nUsage: npm test -- [--only ${Object.keys(kStages).join(',')}]`);
  }
  const names = only ? only.split(',') : Object.keys(kStages);
  const unknown = names.find((name) => !kStages[name]);
  if (unknown !== undefined)
    throw new Stop(`There is no stage '${unknown}'; there are ${Object.keys(kStages).join(', ')}.`);
  return names;
}

async function runStage(name) {
  const { title, work } = kStages[name];
  say(`\n== ${title} (${name})`);
  const started = Date.now();
  let counts;
  try {
    counts = await work();
  } catch (error) {
    say(error instanceof Stop ? error.message : error.stack);
    counts = { passed: 0, failed: 1, note: 'could not be run' };
  }
  const time = duration(Date.now() - started);
  say(
    `-- ${name}: ${counts.passed} passed, ${counts.failed} failed${counts.note ? ` (${counts.note})` : ''} in ${time}`,
  );
  return { name, time, ...counts };
}

await mainProgram(async () => {
  const started = Date.now();
  const names = chosenStages();
  say('== Set-up');
  const parts = [...new Set(names.flatMap((name) => kStages[name].needs))];
  if (parts.length) await setup(parts);
  const results = [];
  for (const name of names) results.push(await runStage(name));
  say('\n== Summary');
  for (const { name, passed, failed, note, time } of results) {
    say(
      `${name.padEnd(9)} ${String(passed).padStart(5)} passed ${String(failed).padStart(4)} failed  ${time}${note ? `  ${note}` : ''}`,
    );
  }
  const all = sumCounts(results);
  say(`All stages took ${duration(Date.now() - started)}; their logs are in ${join(buildDir, 'logs')}.`);
  say(`${all.passed} passed, ${all.failed} failed`);
  return all.failed ? 1 : 0;
});
