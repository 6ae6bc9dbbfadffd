// The texts of the page, found in the sources that show them, and the catalogues that translate them
// (assets/words/ID.json: English text → message in ICU syntax). Whatever a source holds that reads as words is a text of
// the page, so that none is forgotten; what only programs and developers read is told apart by where it stands.
import { readdirSync, readFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { root } from './paths.mjs';

const kCatalogues = join(root, 'assets/words');

/** Engine files with tables of words; all of web/ is read but what draws and what talks to the browser. */
const kEngineFiles = [
  'engine/base/result.cpp',
  'engine/document/params.cpp',
  'engine/inflate/ready_profiles.cpp',
  'engine/sections/blend.cpp',
  'engine/sections/ends.cpp',
  'engine/sections/section.cpp',
  'engine/sections/drawing.cpp',
  'engine/printing/print_check.cpp',
  'engine/shape/ready_shapes.cpp',
  'engine/surface/finish.cpp',
];
/** The pages themselves. */
const kPages = ['web/shell/index.html', 'web/shell/view/view.html'];
const kNotShown =
  /^web\/(gl|platform|scene|main\.cpp|self_crossing\.cpp|cut_out\.cpp|shell\/(solids|cut_out|offline\/(service_worker|protocol)|solids\.worker|site\.d|api|icons|words\/))/;

function filesUnder(folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const file = join(folder, entry.name);
    return entry.isDirectory() ? filesUnder(file) : [file];
  });
}

/** Words for developers and programs: what an argument is to be, asserts, ids, keys of the undo history, CSS, headers. */
const kApart = {
  cpp: [
    /^\s*#\s*include.*$/gm,
    /\/\/.*$/gm,
    /\b(?:static_)?assert\((?:[^()]|\([^()]*\))*\)/g,
    /\bmissing\((?:[^()]|\([^()]*\))*\)/g,
    /Refusal\{"(?:ArgumentMissing|NoSuchCommand)",(?:[^{}"]|"(?:[^"\\]|\\.)*")*\}/g,
    /(?:\.|\b)(?:icon|shortcut|group|id) = "[^"]*"/g,
    /\bError::\w+, (?:std::string\()?"(?:[^"\\]|\\.)*"/g,
    /\b(?:beginFixed|beginCard|BeginChild|Begin)\((?:env, )?"[^"]*"/g,
    /\bBar\{|BarMenu::\w+, "[^"]*"/g,
    /R"\w*\([\s\S]*?\)\w*"/g,
    /\bhash\.text\("[^"]*"\)|\bHasher\(\)\.text\("[^"]*"\)/g,
  ],
  ts: [
    /\/\*[\s\S]*?\*\//g,
    /(^|[^:'"`])\/\/.*$/gm,
    /^(?:import|export) [^;]*? from '[^']*';/gm,
    /\bnew Error\((?:[^()]|\([^()]*\))*\)/g,
    /\bnew Failure\(\s*'\w+'/g,
    /\b(?:class|className|id|role|type|'data-command'|'aria-[a-z]+(?<!label)'): '[^']*'/g,
  ],
};

/** Identifiers, keys of the keyboard, names of things: nothing that a visitor reads as words of a language. */
const kNoWords = [
  /^\{\w+\}$/,
  /^[A-Z][a-z]+(?:[A-Z0-9][A-Za-z]*)+$/,
  /^(?:(?:Ctrl|Shift|Alt)\+)+/,
  /^(?:SpineLoft|SpineLoft Script|Shift\+Arrows|Inter|End|Enter|Escape|Space|Tab|Shift|Alt|Arrow|Meta|Control|Ctrl|Files|Unknown|Mm|Content-Type|Authorization|Retry-After|Offline|Failed|Frozen|Taken|Busy|English|Deutsch)$/,
  / $/,
];

/** The ids that panels name: their buttons show the words of these commands. */
const panelText = filesUnder(join(root, 'web/panels'))
  .map((file) => readFileSync(file, 'utf8'))
  .join('');

/** Rows of the command table for programs alone: their argument has no choices, and no button and no key has them. */
function isForPrograms(row, text) {
  const [, id] = /\.id = "([^"]+)"/.exec(row) ?? [];
  const [, given] = /\.argument = (\w+|\{[^}]*\})/.exec(row) ?? [];
  if (!id || !given || row.includes('.shortcut') || panelText.includes(`"${id}"`)) return false;
  const argument = given.startsWith('{') ? given : new RegExp(`\\b${given}(\\{[^}]*\\})`).exec(text)?.[1];
  return /^\{"\w+"\}$/.test(argument ?? '');
}

function literalsOf(text) {
  const out = [];
  // Neighbours in C++ are one text.
  for (const [whole] of text.matchAll(/(?:"(?:[^"\\\n]|\\.)*"\s*)+|'(?:[^'\\\n]|\\.)*'|`(?:[^`\\]|\\.)*`/g)) {
    const parts = [...whole.matchAll(/"((?:[^"\\\n]|\\.)*)"|^'((?:[^'\\\n]|\\.)*)'$|^`((?:[^`\\]|\\.)*)`$/g)];
    const raw = parts.map((part) => part[1] ?? part[2] ?? part[3]).join('');
    out.push(
      raw
        .replace(/\\x([0-9a-f]{2})\\x([0-9a-f]{2})/g, (_, a, b) =>
          Buffer.from([parseInt(a, 16), parseInt(b, 16)]).toString(),
        )
        .replace(/\\(["'`\\])/g, '$1'),
    );
  }
  return out;
}

/** A sentence, a word with a capital, or a text with arguments; tables of the engine have small words, too. */
function readsAsWords(text, small) {
  if (kNoWords.some((pattern) => pattern.test(text)) || /[<>$=#]|::|^\w+\(/.test(text)) return false;
  return (
    /^"?[A-Z][a-z]+(?:[ ,.?!:'’-]|$)|^A |^3D /.test(text) ||
    /\{\w+\}/.test(text) ||
    (small && /[a-z] [a-z(]/.test(text))
  );
}

function wordsIn(path, text) {
  const kind = path.endsWith('.ts') ? 'ts' : 'cpp';
  // What does not read as words by itself is marked where it stands.
  const mark = kind === 'ts' ? /\bt\(\s*(')((?:[^'\\]|\\.)*)'/g : /\bwords::(?:tr|text)\(\s*(")((?:[^"\\]|\\.)*)"/g;
  const marked = [...text.matchAll(mark)].map((m) => m[2].replace(/\\(["'])/g, '$1'));
  let shown = text.replace(/Command\{(?:[^{}]|\{[^{}]*\})*\}/g, (row) => (isForPrograms(row, text) ? ' ' : row));
  for (const pattern of kApart[kind])
    shown = shown.replace(pattern, (whole) =>
      kind === 'ts' && whole.endsWith("'") && !whole.startsWith('new') ? '' : ' ',
    );
  const small = path.startsWith('engine/');
  return [
    ...literalsOf(shown).filter((one) => readsAsWords(one, small)),
    ...marked.filter((one) => /\p{L}/u.test(one)),
  ];
}

/** Texts and spoken attributes of a page; entities do not occur. */
function wordsOfPage(html) {
  const body = html.slice(html.indexOf('<body'), html.indexOf('</body'));
  const texts = [...body.matchAll(/>([^<>]+)</g)].map((m) => m[1].trim());
  const attributes = [...body.matchAll(/(?:aria-label|title|placeholder|alt|data-tip)="([^"]+)"/g)].map((m) => m[1]);
  return [...texts, ...attributes].filter((text) => /\p{L}{2}/u.test(text) && text !== 'SpineLoft');
}

/** Every text of the page → the first file that has it. */
export function pageWords() {
  const found = new Map();
  const add = (path, words) => words.forEach((word) => found.has(word) || found.set(word, path));
  const sources = [...kEngineFiles, ...filesUnder(join(root, 'web')).map((file) => relative(root, file))].filter(
    (path) => /\.(cpp|h|ts)$/.test(path) && !kNotShown.test(path),
  );
  for (const path of sources.sort()) add(path, wordsIn(path, readFileSync(join(root, path), 'utf8')));
  for (const path of kPages) add(path, wordsOfPage(readFileSync(join(root, path), 'utf8')));
  const samples = JSON.parse(readFileSync(join(root, 'assets/samples/samples.json'), 'utf8'));
  add(
    'assets/samples/samples.json',
    samples.flatMap(({ title, alt }) => [title, alt]),
  );
  return found;
}

/** The ids of the catalogues. */
export function catalogueIds() {
  return readdirSync(kCatalogues)
    .filter((name) => name.endsWith('.json'))
    .map((name) => name.slice(0, -'.json'.length))
    .sort();
}

export function catalogue(id) {
  return JSON.parse(readFileSync(join(kCatalogues, `${id}.json`), 'utf8'));
}
