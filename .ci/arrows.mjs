// The house rules that a script can check: which folder may include which, who may know which library, length of files and
// functions.
// The picture of the arrows is at the top; `node .ci/arrows.mjs` prints every line that breaks one and exits with 1.
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { join, relative } from 'node:path';
import { pathToFileURL } from 'node:url';
import { root } from './lib/paths.mjs';

/** Each folder and the folders it may include directly; what those may include comes with them. */
const kArrows = {
  'engine/base': [],
  'engine/geometry': ['engine/base'],
  'engine/mesh': ['engine/geometry'],
  'engine/image': ['engine/base'],
  'engine/vision': ['engine/image'],
  'engine/surface': ['engine/image', 'engine/mesh'],
  'engine/ribs/base': ['engine/geometry', 'engine/image'],
  'engine/ribs/field': ['engine/ribs/base'],
  'engine/ribs/evidence': ['engine/ribs/field'],
  'engine/ribs/labels': ['engine/ribs/base'],
  'engine/ribs/ends': ['engine/ribs/evidence', 'engine/ribs/labels'],
  'engine/ribs/learned': ['engine/ribs/evidence'],
  'engine/ribs/search': ['engine/ribs/ends', 'engine/ribs/learned'],
  'engine/ribs/edit': ['engine/ribs/field'],
  'engine/sections': ['engine/mesh'],
  'engine/loft': ['engine/ribs/base', 'engine/sections'],
  'engine/inflate': ['engine/sections', 'engine/image'],
  'engine/extrude': ['engine/mesh', 'engine/image'],
  'engine/lathe': ['engine/mesh', 'engine/image'],
  'engine/stack': ['engine/sections', 'engine/image'],
  'engine/descriptive': ['engine/inflate'],
  'engine/shape': ['engine/loft'],
  'engine/pull': ['engine/mesh'],
  'engine/bridge': ['engine/mesh'],
  'engine/relief': ['engine/mesh', 'engine/image'],
  'engine/document': [
    'engine/ribs/edit',
    'engine/loft',
    'engine/inflate',
    'engine/extrude',
    'engine/lathe',
    'engine/stack',
    'engine/shape',
    'engine/pull',
    'engine/bridge',
    'engine/relief',
    'engine/descriptive',
    'engine/surface',
  ],
  'engine/printing': ['engine/mesh'],
  'engine/io': ['engine/document'],
  'engine/pipeline': ['engine/ribs/search', 'engine/document', 'engine/vision', 'engine/surface'],
  'engine/publish': ['engine/pipeline', 'engine/io', 'engine/printing'],
  'engine/cli': ['engine/publish'],
  'web/gl': ['engine/mesh', 'engine/image'],
  'web/words': ['engine/base'],
  'web/platform': ['engine/image', 'web/words'],
  'web/model': ['engine/publish', 'web/platform'],
  'web/ui': ['web/model', 'web/gl'],
  'web/edit': ['web/ui'],
  'web/scene': ['web/edit', 'web/gl'],
  'web/commands': ['web/edit'],
  'web/tools': ['web/commands'],
  'web/panels': ['web/commands'],
  'web/page': ['web/tools', 'web/panels', 'web/scene'],
  'web/self_crossing': ['engine/mesh'],
  'web/cut_out': ['engine/vision'],
  'web/main': ['web/page'],
};

/** Libraries, and the only folders whose files may include them. */
const kLibraries = [
  { name: 'OpenCV', pattern: /^opencv2\//, folders: ['engine/vision'] },
  { name: 'tinygltf', pattern: /^tiny_?gltf/, folders: ['tests'] },
  { name: 'stb', pattern: /^(stb\/|stb_)/, folders: ['engine/io'] },
  { name: 'nlohmann json', pattern: /^nlohmann\//, folders: ['engine/io', 'engine/cli', 'web/model'] },
  { name: 'CLI11', pattern: /^CLI\//, folders: ['engine/cli'] },
  { name: 'Emscripten', pattern: /^emscripten/, folders: ['web'] },
  { name: 'OpenGL', pattern: /^(GL|GLES\d?|EGL|KHR)\//, folders: ['web/gl', 'web/platform', 'web/main'] },
  { name: 'Dear ImGui', pattern: /^(imgui|backends\/imgui|imconfig|imstb)/, folders: ['web'] },
  { name: 'GLFW', pattern: /^GLFW\//, folders: ['web'] },
  { name: 'iostream', pattern: /^iostream$/, folders: ['engine/cli', 'web'] },
  {
    name: 'file access',
    pattern: /^(fstream|filesystem|fcntl\.h|unistd\.h)$/,
    folders: ['engine/cli', 'web/platform', 'web/main'],
  },
];

/** In a program without threads the linker places a thread_local of an object compiled for threads over constants. */
const kPerThread = /\bthread_local\b/;
const kCompiledForEachProgram = 'tests/support/scarce_memory.cpp';

const kLongestFile = 600;
const kLongestFunction = 80;
const kCounted = /^(engine|web|shaders|tests|\.ci)\/.*\.(h|hpp|cpp|c|ts|js|mjs|css|html|vert|frag|glsl|cmake)$/;

/** `text` with blanks in place of comments and of texts in quotes; lines stay. */
export function codeOf(text) {
  const kNoCode = /\/\/.*|\/\*[^]*?\*\/|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+'/g;
  return text.replace(kNoCode, (hit) => hit.replace(/[^\n]/g, ' '));
}

/** The folder of kArrows a repository path belongs to: `engine/ribs/field/d2.h` is in `engine/ribs/field`, `web/main.cpp` in `web/main`. */
function folderOf(path) {
  const [top, second, third] = path.split('/');
  if (kArrows[`${top}/${second}/${third}`]) return `${top}/${second}/${third}`;
  return `${top}/${(second ?? '').replace(/\.[a-z]+$/, '')}`;
}

function reach(folder, seen = new Set([folder])) {
  for (const next of kArrows[folder] ?? []) {
    if (!seen.has(next)) reach(next, seen.add(next));
  }
  return seen;
}

function libraryErrors(path, included) {
  return kLibraries
    .filter((library) => library.pattern.test(included))
    .filter((library) => !library.folders.some((folder) => path.startsWith(`${folder}/`) || folderOf(path) === folder))
    .map((library) => `${library.name} is for ${library.folders.join(', ')} only`);
}

function includeErrors(path, quote, included) {
  const errors = libraryErrors(path, included);
  if (quote !== '"' || errors.length) return errors;
  if (!/^(engine|web)\//.test(included)) {
    return ['includes are written from the repository root: "engine/..." or "web/..."'];
  }
  const from = folderOf(path);
  const to = folderOf(included);
  if (!kArrows[to]) return [`${to} is not a folder of the house`];
  return reach(from).has(to) ? [] : [`${from} may not include ${to}`];
}

/**
 * The functions of a formatted text that are too long, as [line, length]: a block ends where its first line is indented.
 * In a script, where a function may be all that is shared by those within it, the lines of these are their own.
 */
function longFunctions(lines, isScript) {
  const indentOf = (line) => line.search(/\S/);
  const found = [];
  let inner = []; // functions that no other one holds yet, as {first, last}
  lines.forEach((line, last) => {
    if (!/^\s*\}/.test(line)) return;
    const within = (other) => other === '' || other.startsWith('#') || indentOf(other) > indentOf(line);
    let first = last - 1;
    while (first >= 0 && within(lines[first])) first -= 1;
    if (first < 0) return;
    const opening =
      lines
        .slice(first, last)
        .join('\n')
        .match(/^[^]*?\{$/m)?.[0] ?? '';
    if (/^\s*(export |abstract |default )*(namespace|class|struct|enum|union|interface)\b/.test(opening)) return;
    if (!/(\)[^()]*|=> )\{$/.test(opening) || /^\s*(\} )?(if|else|for|while|switch|catch)\b/.test(opening)) return;
    const held = inner.filter((one) => one.first > first);
    inner = [...inner.filter((one) => one.first <= first), { first, last }];
    const others = isScript ? held.reduce((sum, one) => sum + one.last - one.first + 1, 0) : 0;
    const length = last - first + 1 - others;
    if (length > kLongestFunction) found.push([first + 1, length]);
  });
  return found;
}

/** Every broken rule in `files`, a list of {path, text} with paths from the repository root, as `path:line: what`. */
export function houseErrors(files) {
  const errors = [];
  for (const { path, text } of files) {
    if (!kCounted.test(path)) continue;
    const lines = text.split('\n');
    if (lines.length - 1 > kLongestFile)
      errors.push(`${path}:1: ${lines.length - 1} lines, at most ${kLongestFile} are allowed`);
    for (const [line, length] of longFunctions(lines, /\.(ts|js|mjs)$/.test(path)))
      errors.push(`${path}:${line}: a function of ${length} lines, at most ${kLongestFunction} are allowed`);
    if (!/\.(h|hpp|cpp|c)$/.test(path)) continue;
    if (path !== kCompiledForEachProgram) {
      codeOf(text)
        .split('\n')
        .forEach((line, index) => {
          if (kPerThread.test(line))
            errors.push(`${path}:${index + 1}: thread_local is for ${kCompiledForEachProgram} only`);
        });
    }
    if (!/^(engine|web)\//.test(path)) continue;
    if (!kArrows[folderOf(path)]) errors.push(`${path}:1: ${folderOf(path)} is not a folder of the house`);
    lines.forEach((line, index) => {
      const hit = line.match(/^\s*#\s*include\s*([<"])([^>"]+)[>"]/);
      if (!hit) return;
      for (const error of includeErrors(path, hit[1], hit[2])) errors.push(`${path}:${index + 1}: ${error}`);
    });
  }
  return errors;
}

function filesUnder(folder) {
  return readdirSync(folder).flatMap((name) => {
    const file = join(folder, name);
    return statSync(file).isDirectory() ? filesUnder(file) : [file];
  });
}

/** All files of the house, as houseErrors wants them. */
export function houseFiles() {
  const tops = readdirSync(root).filter((name) => ['engine', 'web', 'shaders', 'tests', '.ci'].includes(name));
  return tops
    .flatMap((top) => filesUnder(join(root, top)))
    .map((file) => relative(root, file))
    .filter((path) => kCounted.test(path))
    .map((path) => ({ path, text: readFileSync(join(root, path), 'utf8') }));
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  const files = houseFiles();
  const errors = houseErrors(files);
  for (const error of errors) console.log(error);
  console.log(`${files.length} files read, ${errors.length} rules broken`);
  process.exitCode = errors.length ? 1 : 0;
}
