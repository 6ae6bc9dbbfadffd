// Running a doctest program: its test cases in stretches, one processor each.
import { doctestCounts, doctestTotal, nothing, stretchCounts, sumCounts, testStretches } from './counts.mjs';
import { dataFolder, root } from './paths.mjs';
import { run, say } from './run.mjs';

const kMinutes = 60000;
const kQuiet = ['--no-colors', '--no-version'];

/** The suite of the tests that need the data folder: where there is none they are counted as skipped. */
const kData = 'data';

/** doctest's arguments for `{only, but, files, butFiles}`: the suites that run, those that do not, and likewise files. */
export function suiteFilter({ only = [], but = [], files = [], butFiles = [] }) {
  return [
    ...(only.length ? [`--test-suite=${only.join(',')}`] : []),
    ...(but.length ? [`--test-suite-exclude=${but.join(',')}`] : []),
    ...(files.length ? [`--source-file=${files.join(',')}`] : []),
    ...(butFiles.length ? [`--source-file-exclude=${butFiles.join(',')}`] : []),
  ];
}

/**
 * Runs `program` ({name, command, args, env}) over the suites of `suites` (see suiteFilter) on `lanes`, in stretches.
 * A stretch that breaks off is a failure by itself. Resolves to the counts.
 */
export async function doctest(program, suites, lanes) {
  const { name, command, args, env } = program;
  const options = {
    cwd: root,
    env: { ...(dataFolder ? { SPINELOFT_DATA: dataFolder } : {}), ...env },
    allowFailure: true,
    log: `${name}-tests`,
    timeout: 40 * kMinutes,
  };
  const call = (label, words) => run(label, command, [...args, ...words, ...kQuiet], options);
  const count = (filter) => call(`the list of tests of ${name}`, ['--count', ...filter]);
  const wantsData = !suites.but?.includes(kData) && (!suites.only || suites.only.includes(kData));
  const without = wantsData && !dataFolder ? doctestTotal((await count(suiteFilter({ only: [kData] }))).text) : 0;
  const filter = suiteFilter(without ? { ...suites, but: [...(suites.but ?? []), kData] } : suites);
  const listed = await count(filter);
  const total = doctestTotal(listed.text);
  if (!total) return without ? { ...nothing, skipped: without, note: 'no data folder' } : doctestCounts(listed);
  const stretch = async ({ first, last }) => {
    const label = `the tests ${first} to ${last} of ${name}`;
    const done = await call(label, [...filter, `--first=${first}`, `--last=${last}`]);
    const counts = stretchCounts(done, last - first + 1);
    if (done.status === null) counts.note = `${label} were ${done.problem}`;
    if (counts.failed) say(done.text.trimEnd());
    return counts;
  };
  const stretches = testStretches(total, 4 * lanes.processors);
  const results = await Promise.all(stretches.map((each) => lanes.run(() => stretch(each))));
  return sumCounts([...results, { ...nothing, skipped: without, note: without ? 'no data folder' : '' }]);
}
