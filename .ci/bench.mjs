// npm run bench: stage times of the native and the WebAssembly build, and the accuracy on a data folder when there is
// one ($SPINELOFT_DATA, or ../shared/data/public). Tables go to standard error, one JSON to standard output or --json.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { buildSite } from './build.mjs';
import { buildTargets, presetDir } from './lib/cmake.mjs';
import { buildDir, root } from './lib/paths.mjs';
import { mainProgram, output, run, say, Stop, talkOnStderr } from './lib/run.mjs';
import { siteSizes } from './lib/site.mjs';
import { setup } from './setup.mjs';

const kMinutes = 60000;

function options() {
  try {
    return parseArgs({ options: { json: { type: 'string' }, data: { type: 'string' } } }).values;
  } catch (error) {
    throw new Stop(`${error.message}\nUsage: npm run bench -- [--json FILE] [--data FOLDER]`);
  }
}

function parsed(text, what) {
  const start = text.search(/^[{[]/m);
  try {
    return JSON.parse(text.slice(start));
  } catch (error) {
    throw new Stop(`${what} printed no JSON (${error.message}):\n${text.slice(0, 400)}`);
  }
}

function shown(value) {
  if (typeof value !== 'number') return value ?? '';
  return Number.isInteger(value) ? String(value) : value.toPrecision(3);
}

/** Rows of objects as text; `columns` maps a heading to the key, or to a function of the row, that fills it. */
function printTable(title, rows, columns) {
  const cells = rows.map((row) => Object.values(columns).map((key) => shown(typeof key === 'function' ? key(row) : row[key])));
  const widths = Object.keys(columns).map((head, index) => Math.max(head.length, ...cells.map((line) => line[index].length)));
  const line = (texts) => texts.map((text, i) => (i ? text.padStart(widths[i]) : text.padEnd(widths[i]))).join('  ');
  say(`\n${title}\n${line(Object.keys(columns))}`);
  for (const texts of cells) say(line(texts));
}

/** Median and 95th percentile of each stage, one pair of columns per build. */
function printStages(stages) {
  const columns = { 'stage times in ms': 'name' };
  for (const build of Object.keys(stages)) {
    columns[build] = ({ name }) => stages[build][name]?.median_ms;
    columns[`${build} p95`] = ({ name }) => stages[build][name]?.p95_ms;
  }
  printTable('Stages', Object.keys(stages.native).map((name) => ({ name })), columns);
}

function printAccuracy({ summary, cases }, folder) {
  const scores = { IoU: 'iou', 'IoU body': 'iou_body', 'rib error %': 'rib_mean_pct', 'within tol.': 'rib_within_tol' };
  printTable(`Accuracy on ${folder}`, summary, {
    strokes: 'name',
    cases: 'cases',
    ...scores,
    'body > 0.9': 'share_iou_body_0.9',
    'body > 0.8': 'share_iou_body_0.8',
    edge: 'share_ends_edge',
    bridged: 'share_ends_bridged',
    guessed: 'share_ends_guessed',
    failed: 'failed',
  });
  printTable('Each case', cases, { case: 'name', ...scores, edge: 'ends_edge', bridged: 'ends_bridged', guessed: 'ends_guessed', 'ribs ms': 'ribs_ms' });
}

async function stageTimes() {
  const native = await run('the native benchmark', join(presetDir('native-release'), 'spineloft_bench'), [], { log: 'bench', timeout: 20 * kMinutes });
  const columns = { native: parsed(native.text, 'The native benchmark') };
  for (const [name, preset] of [['wasm threads', 'wasm-release'], ['wasm single', 'wasm-release-st']]) {
    const program = join(presetDir(preset), 'spineloft_bench.js');
    const done = await run(`the benchmark of ${preset}`, process.execPath, [program], { log: 'bench', timeout: 20 * kMinutes });
    columns[name] = parsed(done.text, `The benchmark of ${preset}`);
  }
  return columns;
}

async function accuracy(data) {
  const file = join(buildDir, 'bench-accuracy.json');
  const program = join(presetDir('native-release'), 'spineloft');
  await run('spineloft bench', program, ['bench', data, '--json', file], { log: 'bench', timeout: 30 * kMinutes });
  return JSON.parse(readFileSync(file, 'utf8'));
}

await mainProgram(async () => {
  const { json, data } = options();
  talkOnStderr();
  await setup(['native', 'wasm', 'node']);
  await buildTargets('native-release', ['spineloft', 'spineloft_bench']);
  await buildTargets('wasm-release', ['spineloft_bench']);
  await buildTargets('wasm-release-st', ['spineloft_bench']);
  await buildSite();
  const result = {
    commit: output('git', ['rev-parse', '--short', 'HEAD'], { cwd: root }),
    machine: { cpu: cpus()[0]?.model ?? 'unknown', cores: cpus().length, node: process.version },
    stages: await stageTimes(),
    sizes: siteSizes(),
  };
  printStages(result.stages);
  if (result.sizes.length) printTable('Sizes in bytes', result.sizes, { file: 'file', raw: 'raw', gzip: 'gzip', brotli: 'brotli' });
  const folder = data ?? process.env.SPINELOFT_DATA ?? join(root, '../shared/data/public');
  if (existsSync(folder)) {
    result.accuracy = await accuracy(resolve(process.env.INIT_CWD ?? '.', folder));
    printAccuracy(result.accuracy, folder);
  } else {
    say(`\nNo data folder at ${folder}: accuracy is left out.`);
  }
  const text = JSON.stringify(result, null, 2) + '\n';
  if (!json) return void process.stdout.write(text);
  const to = resolve(process.env.INIT_CWD ?? '.', json);
  mkdirSync(join(to, '..'), { recursive: true });
  writeFileSync(to, text);
  say(`\nWritten: ${to}`);
});
