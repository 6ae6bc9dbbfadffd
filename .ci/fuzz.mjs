// npm run fuzz -- [--seconds N] [--target project|picture]: libFuzzer under AddressSanitizer and
// UndefinedBehaviorSanitizer. Begins with tests/corpus/TARGET and what earlier runs found (build/fuzz/TARGET); an input
// that breaks something is left in build/fuzz and belongs into tests/corpus, where the unit tests replay it.
import { cpSync, mkdirSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { buildTargets, presetDir } from './lib/cmake.mjs';
import { buildDir, root } from './lib/paths.mjs';
import { mainProgram, output, run, say, Stop } from './lib/run.mjs';
import { setup } from './setup.mjs';

const kTargets = readdirSync(join(root, 'tests/corpus')).sort();

function options() {
  try {
    const { seconds, target } = parseArgs({
      options: { seconds: { type: 'string', default: '60' }, target: { type: 'string' } },
    }).values;
    if (!/^[1-9]\d{0,5}$/.test(seconds)) throw new Error(`--seconds must be a whole number, not '${seconds}'`);
    if (target !== undefined && !kTargets.includes(target)) throw new Error(`there is no target '${target}'`);
    return { seconds: Number(seconds), targets: target ? [target] : kTargets };
  } catch (error) {
    throw new Stop(`${error.message}\nUsage: npm run fuzz -- [--seconds N] [--target ${kTargets.join('|')}]`);
  }
}

async function fuzz(target, seconds) {
  const corpus = join(buildDir, 'fuzz', target);
  mkdirSync(corpus, { recursive: true });
  cpSync(join(root, 'tests/corpus', target), corpus, { recursive: true });
  say(`Fuzzing ${target} for ${seconds} s`);
  const args = [
    `-max_total_time=${seconds}`,
    '-max_len=8192',
    '-timeout=20',
    '-rss_limit_mb=2048',
    '-print_final_stats=1',
    '-verbosity=1',
    `-artifact_prefix=${join(buildDir, 'fuzz', `${target}-`)}`,
    corpus,
  ];
  const env = {
    UBSAN_OPTIONS: 'print_stacktrace=1:halt_on_error=1',
    ASAN_SYMBOLIZER_PATH: output('sh', ['-c', 'command -v llvm-symbolizer-19']) ?? '',
  };
  const done = await run(`the fuzzer ${target}`, join(presetDir('native-fuzz'), `${target}_fuzz`), args, {
    cwd: root,
    env,
    show: true,
    allowFailure: true,
    log: `fuzz-${target}`,
    timeout: (seconds + 300) * 1000,
  });
  return !done.problem;
}

await mainProgram(async () => {
  const { seconds, targets } = options();
  await setup(['native']);
  await buildTargets(
    'native-fuzz',
    targets.map((target) => `${target}_fuzz`),
  );
  let sound = true;
  for (const target of targets) sound = (await fuzz(target, seconds)) && sound;
  say(sound ? 'Nothing was found.' : `Something was found: see ${join(buildDir, 'fuzz')}.`);
  return sound ? 0 : 1;
});
