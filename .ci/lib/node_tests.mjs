// Running test files with node:test, one process each.
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, statSync } from 'node:fs';
import { basename, join } from 'node:path';
import { nodeTestCounts, nothing, sumCounts } from './counts.mjs';
import { buildDir, root } from './paths.mjs';
import { duration, run, say } from './run.mjs';

const kMinutes = 60000;
/** Of one test, times the rounds: what waits for ever is named instead of holding all up. */
const kMostTestMinutes = 15;

/** The test files (*.test.mjs) of these folders of the repository, sorted. */
export function testFiles(folders) {
  return folders
    .filter((folder) => existsSync(join(root, folder)))
    .flatMap((folder) => readdirSync(join(root, folder)).map((file) => join(folder, file)))
    .filter((file) => file.endsWith('.test.mjs'))
    .sort();
}

/** Runs one file; its readable report goes to the screen when it has ended, the TAP one is counted. */
async function testFile(name, file, env) {
  const tap = join(buildDir, 'logs', `${name}-${basename(file, '.mjs')}.tap`);
  mkdirSync(join(buildDir, 'logs'), { recursive: true });
  rmSync(tap, { force: true });
  const args = [
    '--test',
    '--test-reporter=spec',
    '--test-reporter-destination=stdout',
    '--test-reporter=tap',
    `--test-reporter-destination=${tap}`,
    `--test-timeout=${kMostTestMinutes * kMinutes * Number(env.SPINELOFT_ROUNDS ?? 1)}`,
    file,
  ];
  const options = { cwd: root, env: { NODE_OPTIONS: '', ...env }, allowFailure: true, log: `${name}-tests` };
  const started = Date.now();
  const done = await run(file, process.execPath, args, { ...options, timeout: 50 * kMinutes });
  const text = existsSync(tap) ? readFileSync(tap, 'utf8') : '';
  const counts = nodeTestCounts({ text, status: done.status });
  if (counts.note || done.status === null) counts.note = `${file}: ${counts.note || done.problem}`;
  if (counts.failed) say(done.text.trimEnd());
  say(`   ${file}: ${counts.passed} of ${counts.passed + counts.failed} in ${duration(Date.now() - started)}`);
  return counts;
}

/**
 * Runs `files` as `lanes` become free, the largest first, so that none of the long ones is alone at the end. `wanted`: lanes
 * of one file. Resolves to the counts.
 */
export async function nodeTests(name, files, { lanes, wanted }, env = {}) {
  if (!files.length) return { ...nothing, failed: 1, note: `no test file for ${name}` };
  const size = (file) => statSync(join(root, file)).size;
  const ordered = [...files].sort((a, b) => size(b) - size(a));
  return sumCounts(await Promise.all(ordered.map((file) => lanes.run(() => testFile(name, file, env), wanted))));
}
