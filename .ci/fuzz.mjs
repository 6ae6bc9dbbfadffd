// npm run fuzz -- [--seconds N] [--documents N] [--target document|picture|project|share]: libFuzzer under AddressSanitizer and
// UndefinedBehaviorSanitizer, files for so many seconds and documents so many. Begins with tests/corpus/TARGET and what
// earlier runs found (build/fuzz/TARGET); an input that breaks something is left in build/fuzz and belongs into
// tests/corpus, where the unit tests replay it.
import { cpSync, mkdirSync, readdirSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { buildTargets, presetDir } from './lib/cmake.mjs';
import { buildDir, root } from './lib/paths.mjs';
import { duration, mainProgram, output, run, say, Stop } from './lib/run.mjs';
import { setup } from './setup.mjs';

const kTargets = readdirSync(join(root, 'tests/corpus')).sort();

/** What takes so long that it is counted, not timed: a document is derived, planned for the solver, and written. */
const kCounted = 'document';

const isCount = (text) => /^[1-9]\d{0,6}$/.test(text);

function options() {
  try {
    const { seconds, documents, target } = parseArgs({
      options: {
        seconds: { type: 'string', default: '60' },
        documents: { type: 'string', default: '100000' },
        target: { type: 'string' },
      },
    }).values;
    for (const [name, value] of Object.entries({ seconds, documents }))
      if (!isCount(value)) throw new Error(`--${name} must be a whole number, not '${value}'`);
    if (target !== undefined && !kTargets.includes(target)) throw new Error(`there is no target '${target}'`);
    return {
      seconds: Number(seconds),
      documents: Number(documents),
      targets: target ? [target] : kTargets,
    };
  } catch (error) {
    throw new Stop(
      `${error.message}\nUsage: npm run fuzz -- [--seconds N] [--documents N] [--target ${kTargets.join('|')}]`,
    );
  }
}

/** One process of the fuzzer; true when it found nothing. */
async function fuzz(target, { name, limits, seconds }) {
  const corpus = join(buildDir, 'fuzz', target);
  const args = [
    ...limits,
    '-timeout=20',
    '-rss_limit_mb=2048',
    '-print_final_stats=1',
    '-print_funcs=0',
    `-artifact_prefix=${join(buildDir, 'fuzz', `${target}-`)}`,
    corpus,
  ];
  const env = {
    UBSAN_OPTIONS: 'print_stacktrace=1:halt_on_error=1',
    ASAN_SYMBOLIZER_PATH: output('sh', ['-c', 'command -v llvm-symbolizer-19']) ?? '',
  };
  const done = await run(`the fuzzer ${name}`, join(presetDir('native-fuzz'), `${target}_fuzz`), args, {
    cwd: root,
    env,
    show: true,
    allowFailure: true,
    log: `fuzz-${name}`,
    timeout: (seconds + 300) * 1000,
  });
  return !done.problem;
}

const kLongestSeconds = 24 * 3600;

/** As many documents as asked for, on all processors. */
async function fuzzDocuments(documents) {
  const started = Date.now(),
    processes = Math.min(documents, availableParallelism());
  say(`Fuzzing ${documents} documents in ${processes} processes`);
  const runs = Math.ceil(documents / processes);
  const found = await Promise.all(
    Array.from({ length: processes }, (_, i) =>
      fuzz(kCounted, {
        name: `${kCounted}-${i + 1}`,
        limits: [`-runs=${runs}`, '-max_len=128', `-seed=${(Date.now() % 1_000_000) + i + 1}`],
        seconds: kLongestSeconds,
      }),
    ),
  );
  const took = Date.now() - started,
    tried = runs * processes;
  if (found.every(Boolean))
    say(`${tried} documents took ${duration(took)}: ${((1000 * tried) / took).toFixed(1)} a second.`);
  return found.every(Boolean);
}

async function fuzzFiles(target, seconds) {
  say(`Fuzzing ${target} for ${seconds} s`);
  return fuzz(target, { name: target, limits: [`-max_total_time=${seconds}`, '-max_len=8192'], seconds });
}

await mainProgram(async () => {
  const { seconds, documents, targets } = options();
  await setup(['native']);
  await buildTargets(
    'native-fuzz',
    targets.map((target) => `${target}_fuzz`),
  );
  let sound = true;
  for (const target of targets) {
    const corpus = join(buildDir, 'fuzz', target);
    mkdirSync(corpus, { recursive: true });
    cpSync(join(root, 'tests/corpus', target), corpus, { recursive: true });
    sound = (await (target === kCounted ? fuzzDocuments(documents) : fuzzFiles(target, seconds))) && sound;
  }
  say(sound ? 'Nothing was found.' : `Something was found: see ${join(buildDir, 'fuzz')}.`);
  return sound ? 0 : 1;
});
