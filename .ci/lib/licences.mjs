// What a site is made of besides the project itself, and whether assets/LICENSES.md names all of it with its licence.
import { readdirSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { presetDir } from './cmake.mjs';
import { root } from './paths.mjs';
import { output, Stop } from './run.mjs';

/** Which library a file outside of the project belongs to, by its path in the set-up's cache; the first group is its version. */
const kLibraries = [
  ['Eigen', /\/headers-[^/]+\/(?:Eigen|unsupported)\//],
  ['JSON for Modern C++', /\/headers-[^/]+\/nlohmann\//],
  ['stb', /\/headers-[^/]+\/(?:stb\/)?stb_\w+\.h$/],
  ['Dear ImGui', /\/imgui-([\d.]+)-/],
  ['OpenCV', /\/opencv-([\d.]+)-/],
  ['Emscripten', /\/emscripten-([\d.]+)-/],
  ['LLVM', /\/lib\/clang\/\d+\/include\//],
];

/** The list of common headers that CMake writes: of the checkout that compiled it, for all that share the cache. */
const kCommonHeaders = /\/headers-[0-9a-f]+\.h$/;

/** The library of a file; null for the project's own. */
export function libraryOf(path) {
  if (kCommonHeaders.test(path)) return null;
  for (const [name, pattern] of kLibraries) {
    const found = pattern.exec(path);
    if (found) return { name, version: found[1] ?? null };
  }
  return resolve(path).startsWith(root) ? null : { name: path, version: null };
}

/** The modules of OpenCV that the recipe of .ci/opencv compiles files of. */
function openCvModules() {
  const recipe = readFileSync(join(root, '.ci/opencv/CMakeLists.txt'), 'utf8');
  return [...new Set([...recipe.matchAll(/"\$\{SOURCE\}\/(\w+)\/src\/\\\\1\.cpp"/g)].map(([, name]) => name))];
}

/** Objects of the page's programs, as CMake puts them. */
const kOfPage = /^(CMakeFiles\/spineloft_(engine|cut_outs|threads|no_threads)\.dir|web\/CMakeFiles)\//;

/** The libraries that these programs of the page (files that are linked) include and are linked with. */
function linkedLibraries(programs) {
  const folder = presetDir('wasm-release');
  const paths = new Set();
  let isOfPage = false;
  for (const line of (output('ninja', ['-C', folder, '-t', 'deps']) ?? '').split('\n')) {
    if (!line.startsWith(' ')) isOfPage = kOfPage.test(line);
    else if (isOfPage) paths.add(line.trim());
  }
  for (const program of programs) {
    const inputs = output('ninja', ['-C', folder, '-t', 'query', `web/${program}`]) ?? '';
    for (const [, path] of inputs.matchAll(/^ +\|? ?(\/\S+)$/gm)) paths.add(path);
  }
  if (paths.size === 0) throw new Stop('What the page is linked with is not known: ninja told nothing.');
  return [...paths].map((path) => libraryOf(resolve(folder, path))).filter((library) => library !== null);
}

/** The npm packages of these files of the repository. */
export function packagesOf(files) {
  const names = files.map((file) => /(?:^|\/)node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(file)?.[1]);
  return [...new Set(names.filter(Boolean))].map((name) => ({
    name,
    version: JSON.parse(readFileSync(join(root, 'node_modules', name, 'package.json'), 'utf8')).version,
  }));
}

/** What LICENSES.md says of a library: its row of a table or its item of a list; undefined when it does not name it. */
function entryOf(text, name) {
  const entries = text.split(/\n(?=[-|#]|\n)/);
  return entries.find(
    (entry) => entry.includes(`**${name}**`) || entry.includes(`\`${name}\``) || entry.startsWith(`| ${name}`),
  );
}

/**
 * What is wrong with LICENSES.md, `text`, in sentences: a library that it does not name, names in another version or
 * without a licence; a module of OpenCV likewise; a text in `texts`, the files in licences/, that is missing or not used.
 */
export function licenceFaults({ libraries, modules, text, texts }) {
  const faults = new Set();
  for (const { name, version } of libraries) {
    const entry = entryOf(text, name);
    const said = entry?.match(/\d+\.\d+\.\d+/)?.[0];
    if (entry === undefined) faults.add(`${name} is part of the site and not named.`);
    else if (!entry.includes('](licences/')) faults.add(`${name} has no text of its licence.`);
    else if (version && said && said !== version) faults.add(`${name} is version ${version}, not ${said}.`);
  }
  const named = /OpenCV[^(]*\(([^)]*)\)/.exec(text)?.[1].split(/,\s*/) ?? [];
  for (const module of modules)
    if (!named.includes(module)) faults.add(`The module ${module} of OpenCV is part of the site and not named.`);
  const linked = new Set([...text.matchAll(/\]\(licences\/([^)]+\.txt)\)/g)].map(([, file]) => file));
  for (const file of linked) if (!texts.includes(file)) faults.add(`licences/${file} is missing.`);
  for (const file of texts) if (!linked.has(file)) faults.add(`licences/${file} is the licence of nothing.`);
  return [...faults];
}

/** Stops unless LICENSES.md names everything that a site with these programs and bundled files is made of. */
export function checkLicences(programs, files) {
  const faults = licenceFaults({
    libraries: [...linkedLibraries(programs), ...packagesOf(files)],
    modules: openCvModules(),
    text: readFileSync(join(root, 'assets/LICENSES.md'), 'utf8'),
    texts: readdirSync(join(root, 'assets/licences')),
  });
  if (faults.length) throw new Stop(`assets/LICENSES.md is not true:\n${faults.join('\n')}`);
}
