// npm run bench: stage times of the native and the WebAssembly build, and the accuracy on a data folder when there is
// one ($SPINELOFT_DATA, or ../shared/data/public). Tables go to standard error, one JSON to standard output or --json.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
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

/** Every number of a JSON value under its path; list entries that have a name go by it. */
function numbersOf(value, path = '', into = new Map()) {
  if (typeof value === 'number') into.set(path, value);
  else if (value && typeof value === 'object') {
    for (const [key, inner] of Object.entries(value)) {
      const label = Array.isArray(value) ? (inner?.name ?? key) : key;
      numbersOf(inner, path ? `${path} ${label}` : `${label}`, into);
    }
  }
  return into;
}

function shown(value) {
  if (value === undefined) return '';
  return Number.isInteger(value) ? String(value) : value.toPrecision(4);
}

/** One row per measured number, one column per build. */
function printTable(title, columns) {
  const tables = Object.entries(columns).map(([name, value]) => [name, numbersOf(value)]);
  const rows = [...new Set(tables.flatMap(([, numbers]) => [...numbers.keys()]))];
  const width = Math.max(20, ...rows.map((row) => row.length)) + 2;
  say(`\n${title.padEnd(width)}${tables.map(([name]) => name.padStart(18)).join('')}`);
  for (const row of rows) {
    say(row.padEnd(width) + tables.map(([, numbers]) => shown(numbers.get(row)).padStart(18)).join(''));
  }
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
  await setup(['native', 'wasm']);
  await buildTargets('native-release', ['spineloft', 'spineloft_bench']);
  await buildTargets('wasm-release', ['spineloft_bench']);
  await buildTargets('wasm-release-st', ['spineloft_bench']);
  const result = {
    commit: output('git', ['rev-parse', '--short', 'HEAD'], { cwd: root }),
    machine: { cpu: cpus()[0]?.model ?? 'unknown', cores: cpus().length, node: process.version },
    stages: await stageTimes(),
    sizes: siteSizes(),
  };
  printTable('stage times', result.stages);
  if (result.sizes.length) printTable('size in bytes', { bytes: result.sizes.map(({ file, ...rest }) => ({ name: file, ...rest })) });
  const folder = data ?? process.env.SPINELOFT_DATA ?? join(root, '../shared/data/public');
  if (existsSync(folder)) {
    result.accuracy = await accuracy(resolve(process.env.INIT_CWD ?? '.', folder));
    const { cases, ...summary } = result.accuracy;
    printTable(`accuracy on ${folder}`, { all: summary });
    if (cases) printTable('each case', { value: cases });
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
