// npm test: set-up, then every check and test program of the project. The last line is the sum of all runners.
// npm run test:all (--all): every suite on every build, both engines on the page, and random tests many times as long.
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { houseErrors, houseFiles } from './arrows.mjs';
import { buildSite } from './build.mjs';
import { browserFlags, browserPath } from './lib/browser.mjs';
import { buildTargets, presetDir } from './lib/cmake.mjs';
import { countsLine, nothing, sumCounts } from './lib/counts.mjs';
import { doctest } from './lib/doctest.mjs';
import { formatErrors } from './lib/format.mjs';
import { kLanesPerProcessor, Lanes } from './lib/lanes.mjs';
import { nodeTests, testFiles } from './lib/node_tests.mjs';
import { buildDir, root } from './lib/paths.mjs';
import { duration, mainProgram, output, run, say, Stop } from './lib/run.mjs';
import { setup } from './setup.mjs';

/** How many times as long `npm run test:all` runs what is random: natively, and where every step takes several times. */
const kManyRounds = 20,
  kSlowRounds = 3;

/** A page test waits for a third of its time: for frames, for the disk, for pauses that a hand makes. */
const kPageLanes = kLanesPerProcessor - 1;

const lanes = new Lanes();

const nativeProgram = join(presetDir('native-release'), 'spineloft');

async function arrows() {
  const errors = [...houseErrors(houseFiles()), ...(await formatErrors())];
  for (const error of errors) say(error);
  return { ...nothing, passed: errors.length ? 0 : 1, failed: errors.length ? 1 : 0 };
}

async function types() {
  const tsc = join(root, 'node_modules/typescript/bin/tsc');
  const options = { cwd: root, show: true, allowFailure: true };
  const done = await run('tsc', process.execPath, [tsc, '--noEmit', '-p', 'web/shell'], options);
  return { ...nothing, passed: done.problem ? 0 : 1, failed: done.problem ? 1 : 0 };
}

const kSanitizers = {
  ASAN_OPTIONS: 'detect_stack_use_after_return=1:strict_string_checks=1:malloc_context_size=6',
  UBSAN_OPTIONS: 'print_stacktrace=1:halt_on_error=1',
};

/** Whether random tests go on for long, as in `npm run test:all`. */
const many = (env) => env.SPINELOFT_ROUNDS > 1;

/** The program with every other seed of long random tests: two builds share them out. */
const withSeeds = (program, seeds) => ({ ...program, env: { ...program.env, SPINELOFT_SEEDS: seeds } });

const underNode = (name) => ({
  name,
  command: process.execPath,
  args: [join(presetDir('wasm-release'), `${name}.js`)],
});

/** Under the sanitizers, but for what takes minutes there and only reads numbers. */
function asan(env) {
  const symbolizer = output('sh', ['-c', 'command -v llvm-symbolizer-19']) ?? '';
  const program = {
    name: 'native-asan',
    command: join(presetDir('native-asan'), 'spineloft_tests'),
    args: [],
    env: { ...kSanitizers, ASAN_SYMBOLIZER_PATH: symbolizer, ...env },
  };
  return many(env)
    ? doctest(program, {}, lanes)
    : doctest(withSeeds(program, 'even'), { but: ['data', 'slow'] }, lanes);
}

/** The native test program: with all cases, or with those files alone that have what takes long or reads the data. */
const nativeTests = (env) => (many(env) ? 'spineloft_tests' : 'spineloft_tests_slow');

/** What ships, and on the data once: the other builds give the same numbers (tests/cli/agree). */
function native(env) {
  const program = {
    name: 'native-release',
    command: join(presetDir('native-release'), nativeTests(env)),
    args: [],
    env,
  };
  return doctest(program, many(env) ? {} : { only: ['data', 'slow'] }, lanes);
}

const kWebTests = ['*/unit/web/*'];

/**
 * The engine, optimised, with the numbers of WebAssembly. The page's side runs as WebAssembly in the page tests; of its
 * cases the programs have what takes long and what needs threads.
 */
async function wasmSingle(env) {
  const program = { ...underNode('spineloft_tests_single'), env };
  if (many(env)) return doctest(program, { but: ['data'] }, lanes);
  const engine = { but: ['data', 'slow'], butFiles: kWebTests };
  return sumCounts(
    await Promise.all([
      doctest(withSeeds(program, 'odd'), engine, lanes),
      doctest(program, { only: ['slow'], files: kWebTests }, lanes),
    ]),
  );
}

/** The same objects with threads. */
const wasmThreads = (env) =>
  doctest({ ...underNode('spineloft_tests'), env }, many(env) ? { but: ['data'] } : { only: ['threads'] }, lanes);

const cli = (env) =>
  nodeTests('node', testFiles(['.ci/tests', 'tests/cli']), { lanes }, { ...env, SPINELOFT_CLI: nativeProgram });

const share = (env) => nodeTests('share', testFiles(['tests/share']), { lanes }, env);

const shell = (env) => nodeTests('shell', testFiles(['tests/shell']), { lanes }, env);

/**
 * Only what runs for long is optimised: a page of a test ends soon after its start, and to optimise what starts it takes
 * two thirds of what is compiled there. What is optimised once a page is that of visitors: in `npm run test:all`.
 */
const kLateOptimising = '--js-flags=--wasm-tiering-budget=300000000';

/** The page tests, on one Chromium for all of them. */
async function page(env) {
  const { chromium } = await import('playwright-core');
  const args = many(env) ? browserFlags : [...browserFlags, kLateOptimising];
  const server = await chromium.launchServer({ executablePath: browserPath(), args, headless: true });
  try {
    return await nodeTests(
      'browser',
      testFiles(['tests/browser']),
      { lanes, wanted: kPageLanes },
      {
        ...env,
        SPINELOFT_CLI: nativeProgram,
        SPINELOFT_BROWSER_WS: server.wsEndpoint(),
        ...(many(env) ? { SPINELOFT_ALL_DRAW: '1' } : {}),
      },
    );
  } finally {
    await server.close();
  }
}

/** What every build for WebAssembly needs here. */
const kWasm = ['wasm', 'opencv'];

const kBuilds = {
  native: { needs: ['native'], build: (env) => buildTargets('native-release', [nativeTests(env), 'spineloft']) },
  command: {
    needs: ['native'],
    build: () => buildTargets('native-release', ['spineloft', 'spineloft_accuracy', 'spineloft_bench']),
  },
  asan: { needs: ['native'], build: () => buildTargets('native-asan', ['spineloft_tests']) },
  wasm: {
    needs: kWasm,
    build: () => buildTargets('wasm-release', ['spineloft_tests', 'spineloft_tests_single', 'spineloft_bench_single']),
  },
  site: { needs: [...kWasm, 'node'], build: buildSite },
};

// In the order in which they begin: each waits for its builds, and builds go before tests.
const kStages = {
  arrows: { title: 'House rules: include arrows, file lengths, format', needs: ['node', 'format'], work: arrows },
  types: { title: 'TypeScript types', needs: ['node'], work: types },
  asan: {
    title: 'Engine under AddressSanitizer and UndefinedBehaviorSanitizer',
    builds: ['asan'],
    work: asan,
    isSlow: true,
  },
  wasm: {
    title: 'Engine as WebAssembly, single thread, under Node',
    builds: ['wasm'],
    work: wasmSingle,
    isSlow: true,
  },
  threads: {
    title: 'Engine as WebAssembly with threads, under Node',
    builds: ['wasm'],
    work: wasmThreads,
    isSlow: true,
  },
  native: { title: 'Engine, native and optimised', builds: ['native'], work: native },
  shell: { title: 'The shell without a browser', needs: ['node'], builds: ['site'], work: shell },
  share: { title: 'The share server, on SQLite and PostgreSQL', needs: ['store', 'database'], work: share },
  node: {
    title: 'Command line and scripts',
    needs: ['node', 'readers'],
    builds: ['command', 'wasm'],
    work: cli,
  },
  browser: {
    title: 'The page in headless Chromium',
    needs: ['browser', 'store', 'readers'],
    builds: ['site', 'command'],
    work: (env) => page({ SPINELOFT_ENGINE: 'threads', ...env }),
  },
  'browser-single': {
    title: 'The page in headless Chromium, its engine without threads',
    needs: ['browser', 'store', 'readers'],
    builds: ['site', 'command'],
    onlyInAll: true,
    work: (env) => page({ ...env, SPINELOFT_ENGINE: 'single' }),
  },
};

function options() {
  let values;
  try {
    values = parseArgs({ options: { only: { type: 'string' }, all: { type: 'boolean', default: false } } }).values;
  } catch (error) {
    throw new Stop(`${error.message}\nUsage: npm test -- [--all] [--only ${Object.keys(kStages).join(',')}]`);
  }
  const every = Object.keys(kStages).filter((name) => values.all || !kStages[name].onlyInAll);
  const names = values.only ? values.only.split(',') : every;
  const unknown = names.find((name) => !kStages[name]);
  if (unknown !== undefined)
    throw new Stop(`There is no stage '${unknown}'; there are ${Object.keys(kStages).join(', ')}.`);
  return { names, all: values.all };
}

/**
 * What the stages' builds are, each a promise: the native compilers first, then one after the other on all processors. The
 * rest of the set-up, which mostly waits for downloads and for one processor, goes on beside the native builds.
 */
function startBuilds(names, env) {
  const wanted = [...new Set(names.flatMap((name) => kStages[name].builds ?? []))];
  const needs = new Set([
    ...names.flatMap((name) => kStages[name].needs ?? []),
    ...wanted.flatMap((name) => kBuilds[name].needs),
  ]);
  const compilers = needs.has('native') ? setup(['native']) : Promise.resolve();
  const first = compilers.then(() => setup([...needs].filter((part) => !kWasm.includes(part))));
  const second = needs.has('wasm') ? first.then(() => setup(kWasm)) : first;
  const builds = wanted.map((name) => {
    const { needs: parts, build } = kBuilds[name];
    const ready = parts.includes('wasm') ? second : parts.every((part) => part === 'native') ? compilers : first;
    return [name, ready.then(() => lanes.alone(() => build(env)))];
  });
  for (const [, built] of builds) built.catch(() => {}); // told by the stages that wait for it
  return { first, builds: Object.fromEntries(builds) };
}

/** $SPINELOFT_ROUNDS goes before what is usual. */
function environment(name, all) {
  const usual = all ? (kStages[name].isSlow ? kSlowRounds : kManyRounds) : 1;
  return { SPINELOFT_ROUNDS: process.env.SPINELOFT_ROUNDS ?? String(usual) };
}

async function runStage(name, { first, builds }, env) {
  const { title, work } = kStages[name];
  let counts;
  let started = Date.now();
  try {
    await first;
    await Promise.all((kStages[name].builds ?? []).map((build) => builds[build]));
    say(`== ${title} (${name})`);
    started = Date.now();
    counts = await work(env);
  } catch (error) {
    say(error instanceof Stop ? error.message : error.stack);
    counts = { ...nothing, failed: 1, note: 'could not be run' };
  }
  const time = duration(Date.now() - started);
  say(`-- ${name}: ${countsLine(counts)}${counts.note ? ` (${counts.note})` : ''} in ${time}`);
  return { name, time, ...counts };
}

await mainProgram(async () => {
  const started = Date.now();
  const { names, all } = options();
  say('== Set-up and builds');
  const prepared = startBuilds(names, environment('native', all));
  const results = await Promise.all(names.map((name) => runStage(name, prepared, environment(name, all))));
  say('\n== Summary: stages share the processors, so their times overlap');
  for (const { name, note, time, ...counts } of results)
    say(`${name.padEnd(15)} ${countsLine(counts).padEnd(36)} ${time.padStart(12)}${note ? `  ${note}` : ''}`);
  const sum = sumCounts(results);
  say(`All stages took ${duration(Date.now() - started)}; their logs are in ${join(buildDir, 'logs')}.`);
  say(countsLine(sum));
  return sum.failed ? 1 : 0;
});
