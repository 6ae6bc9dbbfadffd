// CMake calls this after it has linked an engine of the page: functions that only the objects of some sources define go to
// a second program, which the page fetches behind the first.
//   node .ci/split_engine.mjs EMSCRIPTEN PROGRAM.wasm SECOND.wasm PATTERN
// in the build's folder; PATTERN of the paths of objects. The program is linked with the linker's names of functions, and
// equal functions are still apart: one of two would be called by the name of either.
import { readdirSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { mainProgram, output, Stop } from './lib/run.mjs';

/** Object files that a program is linked of. */
function objectsOf(program) {
  const name = basename(program, '.wasm');
  const pool = name.endsWith('_single') ? 'spineloft_no_threads' : 'spineloft_threads';
  const own = ['spineloft_app', 'spineloft_web_objects', name].map((target) => `web/CMakeFiles/${target}.dir`);
  const folders = [...['spineloft_engine', pool].map((target) => `CMakeFiles/${target}.dir`), ...own];
  return folders.flatMap((folder) =>
    readdirSync(folder, { recursive: true })
      .filter((path) => path.endsWith('.o'))
      .map((path) => join(folder, path)),
  );
}

function printed(command, args) {
  const text = output(command, args);
  if (text === null) throw new Stop(`${command} failed.`);
  return text;
}

/** Names of the functions that the objects define, weak ones too; with our types, since libraries define others as well. */
function functionsOf(emscripten, objects) {
  const lines = printed(join(emscripten, 'emnm'), ['--defined-only', '--format=posix', ...objects]);
  return [...lines.matchAll(/^(\S*9spineloft\S*) [TtWw] /gm)].map(([, name]) => name);
}

await mainProgram(() => {
  const [emscripten, program, second, pattern] = process.argv.slice(2);
  const isSecond = new RegExp(pattern);
  const objects = objectsOf(program);
  const moved = new Set(
    functionsOf(
      emscripten,
      objects.filter((path) => isSecond.test(path)),
    ),
  );
  if (moved.size === 0) throw new Stop(`No object is named like ${pattern}.`);
  for (const name of functionsOf(
    emscripten,
    objects.filter((path) => !isSecond.test(path)),
  ))
    moved.delete(name);
  const list = `${second}.functions`;
  const first = `${program}.first`;
  writeFileSync(list, [...moved].join('\n'));
  const tools = join(printed(join(emscripten, 'em-config'), ['BINARYEN_ROOT']), 'bin');
  // The prefix is that of platform/second_program.js.
  const outputs = ['-o1', first, '-o2', second, '--export-prefix=%'];
  printed(join(tools, 'wasm-split'), [program, '--all-features', '--quiet', `--split-funcs=@${list}`, ...outputs]);
  for (const file of [first, second]) {
    const passes = ['--optimize-level=3', '--shrink-level=2', '--duplicate-function-elimination'];
    printed(join(tools, 'wasm-opt'), [file, '--all-features', ...passes, '-o', file]);
  }
  renameSync(first, program);
  rmSync(list);
});
