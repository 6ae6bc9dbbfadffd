// npm run bench: stage times of the native and the WebAssembly build, and the accuracy on a data folder when there is
// one ($SPINELOFT_DATA, or ../shared/data/public). Tables go to standard error, one JSON to standard output or --json.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { buildSite } from './build.mjs';
import { buildTargets, presetDir } from './lib/cmake.mjs';
import { buildDir, dataFolder, root } from './lib/paths.mjs';
import { mainProgram, output, run, say, Stop, talkOnStderr } from './lib/run.mjs';
import { editingTimes } from './lib/editing_bench.mjs';
import { siteSizes } from './lib/site.mjs';
import { setup } from './setup.mjs';

const kMinutes = 60000;

function options() {
  try {
    return parseArgs({
      options: {
        json: { type: 'string' },
        markdown: { type: 'string' },
        data: { type: 'string' },
        ablation: { type: 'boolean' },
      },
    }).values;
  } catch (error) {
    throw new Stop(
      `${error.message}\nUsage: npm run bench -- [--json FILE] [--markdown FILE] [--data FOLDER] [--ablation]`,
    );
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

const markdown = [];

/** Rows of objects as text, and for --markdown as a table of it; `columns` maps a heading to the key, or to a function of the row, that fills it. */
function printTable(title, rows, columns) {
  const cells = rows.map((row) =>
    Object.values(columns).map((key) => shown(typeof key === 'function' ? key(row) : row[key])),
  );
  const widths = Object.keys(columns).map((head, index) =>
    Math.max(head.length, ...cells.map((line) => line[index].length)),
  );
  const line = (texts) => texts.map((text, i) => (i ? text.padStart(widths[i]) : text.padEnd(widths[i]))).join('  ');
  say(`\n${title}\n${line(Object.keys(columns))}`);
  for (const texts of cells) say(line(texts));
  const bars = (texts) => `| ${texts.join(' | ')} |`;
  const heads = Object.keys(columns);
  markdown.push(`## ${title}`, '', bars(heads), bars(heads.map((_, i) => (i ? '--:' : ':--'))), ...cells.map(bars), '');
}

const builds = (stages) => Object.keys(stages);
const rowsOf = (stages, kind) =>
  Object.keys(stages.native)
    .filter((name) => kind in stages.native[name])
    .map((name) => ({ name }));

/** Least, median, 95th and 99th percentile of each stage, and the median of what it takes of the processor; then the other numbers. */
function printStages(stages) {
  const columns = { 'stage times in ms': 'name' };
  const values = { value: 'name' };
  for (const build of builds(stages)) {
    columns[`${build} min`] = ({ name }) => stages[build][name]?.min_ms;
    columns[build] = ({ name }) => stages[build][name]?.median_ms;
    columns[`${build} p95`] = ({ name }) => stages[build][name]?.p95_ms;
    columns[`${build} p99`] = ({ name }) => stages[build][name]?.p99_ms;
    columns[`${build} cpu`] = ({ name }) => stages[build][name]?.cpu_ms;
    values[build] = ({ name }) => stages[build][name]?.value;
  }
  printTable('Stages', rowsOf(stages, 'median_ms'), columns);
  printTable('Shares and errors', rowsOf(stages, 'value'), values);
}

/** Stages that are one input in several sizes: what a name says about its size. */
const kGrowth = {
  'spine points': /^ribs (\d+)$/,
  labels: /^labels (\d+)$/,
  megapixels: /^edges of a (quarter|\d)-megapixel picture$/,
};
const kSizes = { quarter: 0.25 };

/** Slope of log time over log size by least squares, for each build: 1 is linear. */
function growth(stages) {
  return Object.entries(kGrowth).map(([what, pattern]) => {
    const row = { what };
    for (const build of builds(stages)) {
      const points = Object.entries(stages[build]).flatMap(([name, times]) => {
        const size = pattern.exec(name)?.[1];
        return size ? [[Math.log(kSizes[size] ?? Number(size)), Math.log(times.min_ms)]] : [];
      });
      const mean = (of) => points.reduce((sum, point) => sum + of(point), 0) / points.length;
      const [x, y] = [mean((p) => p[0]), mean((p) => p[1])];
      row[build] = mean(([a, b]) => (a - x) * (b - y)) / mean(([a]) => (a - x) ** 2);
    }
    return row;
  });
}

function printAccuracy({ summary, cases }, folder) {
  const scores = { IoU: 'iou', 'IoU body': 'iou_body', 'rib error %': 'rib_mean_pct', 'within tol.': 'rib_within_tol' };
  printTable(`Accuracy on ${folder}`, summary, {
    strokes: 'name',
    cases: 'cases',
    ...scores,
    'body > 0.9': 'share_iou_body_0.9',
    'body > 0.8': 'share_iou_body_0.8',
    'between strokes': 'iou_between_strokes',
    'between their ends': 'iou_body_between_strokes',
    edge: 'share_ends_edge',
    bridged: 'share_ends_bridged',
    guessed: 'share_ends_guessed',
    failed: 'failed',
  });
  printTable('A stroke under the pen against a whole trace, in % of the width', summary, {
    strokes: 'name',
    'at pen-up': 'live_up_pct',
    'at pen-up, p95': 'p95_live_up_pct',
    'while it grows': 'live_mean_pct',
    'moments above 5 %': 'live_jumps',
    'moves followed': 'live_followed',
  });
  printTable('Each case', cases, {
    case: 'name',
    ...scores,
    edge: 'ends_edge',
    bridged: 'ends_bridged',
    guessed: 'ends_guessed',
    'ribs ms': 'ribs_ms',
  });
}

function printAblation(lines) {
  const names = Object.keys(lines[0]).filter((key) => key !== 'name');
  printTable('Ablation', lines, { variation: 'name', ...Object.fromEntries(names.map((name) => [name, name])) });
}

function printEditing({ parts, ribs, ...gestures }) {
  printTable(
    `Editing ${parts} parts of ${ribs} ribs in Chromium: from the pointer to the screen`,
    Object.entries(gestures).map(([name, times]) => ({ name, ...times })),
    {
      gesture: 'name',
      'median ms': 'median_ms',
      'p95 ms': 'p95_ms',
      'of the processor, ms': 'thread_ms',
      'drawing, ms': 'drawing_ms',
      'tasks beyond 50 ms': 'long_tasks',
      'the longest, ms': 'longest_ms',
    },
  );
}

async function stageTimes() {
  const native = await run('the native benchmark', join(presetDir('native-release'), 'spineloft_bench'), [], {
    log: 'bench',
    timeout: 20 * kMinutes,
  });
  const photo = await run('a large photo, native', join(presetDir('native-release'), 'spineloft_bench'), ['--photo'], {
    log: 'bench',
    timeout: 5 * kMinutes,
  });
  const columns = {
    native: {
      ...parsed(native.text, 'The native benchmark'),
      ...parsed(photo.text, 'The native benchmark with a photo'),
    },
  };
  for (const [name, file] of [
    ['wasm threads', 'spineloft_bench.js'],
    ['wasm single', 'spineloft_bench_single.js'],
  ]) {
    const program = join(presetDir('wasm-release'), file);
    const done = await run(`the benchmark of ${name}`, process.execPath, [program], {
      log: 'bench',
      timeout: 20 * kMinutes,
    });
    const large = await run(`a large photo, ${name}`, process.execPath, [program, '--photo'], {
      log: 'bench',
      timeout: 5 * kMinutes,
    });
    columns[name] = {
      ...parsed(done.text, `The benchmark of ${name}`),
      ...parsed(large.text, `The benchmark of ${name} with a photo`),
    };
  }
  return columns;
}

async function accuracy(data, withAblation) {
  const file = join(buildDir, 'bench-accuracy.json');
  const program = join(presetDir('native-release'), 'spineloft_accuracy');
  const table = withAblation ? ['--ablation', join(buildDir, 'bench-ablation.md')] : [];
  await run('spineloft_accuracy', program, [data, '--json', file, '--live', '80', ...table], {
    log: 'bench',
    timeout: 30 * kMinutes,
  });
  return JSON.parse(readFileSync(file, 'utf8'));
}

await mainProgram(async () => {
  const { json, markdown: page, data, ablation } = options();
  talkOnStderr();
  await setup(['native', 'wasm', 'opencv', 'node', 'browser']);
  await buildTargets('native-release', ['spineloft_accuracy', 'spineloft_bench']);
  await buildTargets('wasm-release', ['spineloft_bench', 'spineloft_bench_single']);
  await buildSite();
  const result = {
    commit: output('git', ['rev-parse', '--short', 'HEAD'], { cwd: root }),
    machine: { cpu: cpus()[0]?.model ?? 'unknown', cores: cpus().length, node: process.version },
    stages: await stageTimes(),
    sizes: siteSizes(),
    // Its libraries are there only after the set-up.
    solids: (await import('../tests/bench/solids.mjs')).solidTimes(),
    solidsOnPage: await (await import('../tests/bench/solids_page.mjs')).solidPageTimes(),
    editing: await editingTimes(),
    firstLoad: await (await import('../tests/bench/first_load.mjs')).firstLoadTimes(),
  };
  printStages(result.stages);
  result.growth = growth(result.stages);
  printTable('Growth: slope of log time over log size', result.growth, {
    of: 'what',
    ...Object.fromEntries(builds(result.stages).map((build) => [build, build])),
  });
  printEditing(result.editing);
  printTable(
    'Solids: what the worker takes from a request to the mesh',
    Object.entries(result.solids).map(([name, times]) => ({ name, ...times })),
    {
      'stage times in ms': 'name',
      min: 'min_ms',
      median: 'median_ms',
      'least of the processor': 'min_cpu_ms',
      'the first of its kind': 'first_ms',
    },
  );
  printTable(
    'Solids in the worker of a fresh page in Chromium',
    Object.entries(result.solidsOnPage).map(([name, times]) => ({ name, ...times })),
    {
      'from the request to the mesh, ms': 'name',
      min: 'min_ms',
      median: 'median_ms',
      'of the processor, the busiest worker': 'cpu_ms',
    },
  );
  printTable(
    'The first visit in Chromium, from an empty cache',
    Object.entries(result.firstLoad).map(([name, times]) => ({ name, ...times })),
    { where: 'name', 'painted, ms': 'painted_ms', 'can be used, ms': 'usable_ms', 'bytes over the line': 'bytes' },
  );
  if (result.sizes.length)
    printTable('Sizes in bytes', result.sizes, { file: 'file', raw: 'raw', gzip: 'gzip', brotli: 'brotli' });
  const folder = data ?? dataFolder;
  if (folder && existsSync(folder)) {
    result.accuracy = await accuracy(resolve(process.env.INIT_CWD ?? '.', folder), ablation);
    printAccuracy(result.accuracy, folder);
    if (ablation) printAblation(result.accuracy.ablation);
  } else {
    say(`\nNo data folder at ${folder}: accuracy is left out.`);
  }
  const write = (file, text) => {
    const to = resolve(process.env.INIT_CWD ?? '.', file);
    mkdirSync(join(to, '..'), { recursive: true });
    writeFileSync(to, text);
    say(`\nWritten: ${to}`);
  };
  if (page)
    write(
      page,
      `# Benchmark of ${result.commit}\n\n${result.machine.cpu}, ${result.machine.cores} cores, Node ${result.machine.node}\n\n${markdown.join('\n')}`,
    );
  const text = JSON.stringify(result, null, 2) + '\n';
  if (json) write(json, text);
  else process.stdout.write(text);
});
