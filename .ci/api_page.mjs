// Makes assets/docs/api.md from the types of web/shell/api.ts and the command table in assets/docs/commands.json (which a C++ test
// holds to the table of the program). `node .ci/api_page.mjs` writes the page; a test fails while it is out of date.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { root } from './lib/paths.mjs';

export const apiPage = join(root, 'assets/docs/api.md');

const kIntro = `# The API of the page

<!-- Written by .ci/api_page.mjs from web/shell/api.ts and commands.json: change those. -->

\`window.spineloft\` is there as soon as the page's script has run. It is for tests, scripts and pages that embed this one.

Coordinates are pixels of the original picture: x to the right, y down, pixel centres at integers. Failures reject with an \`Error\` whose message is a sentence for a person and
whose \`code\` names the error (\`StrokeTooShort\`, \`PictureTruncated\`, \`NothingToExport\` …). A whole model in a few lines:

\`\`\`js
await spineloft.ready;
await spineloft.openImage(await (await fetch('bottle.jpg')).blob(), 'bottle');
await spineloft.run('draw-spine', { stroke: [[190, 40], [188, 210], [180, 470]] });
await spineloft.run('set-caps', { start: 'flat', end: 'flat' });
await spineloft.idle();
const glb = await spineloft.exportModel('glb');
\`\`\`

A part that is \`waiting\` is shown with a preliminary shape and settles in a moment. After \`idle()\`, and in every export, it is final.
`;

const kCommands = `## Commands

Arguments of \`run(id, args)\`; \`?\` marks what may be left out, \`|\` alternatives. Without \`part\` the selected part is meant, of settings (sections, ends, looks, parameters) and places all parts in hand; \`parts\` names several; without \`step\` the chosen solid.
Places and reaches are shares of the spine's length, 0…1. Ribs, sections and points count from 0. \`side\` is \`'left'\` or \`'right'\` as seen in the drawing direction. \`stroke\` and \`line\` are lists
of \`[x, y]\`, \`to\` and \`by\` are \`[x, y]\`. With \`keep: true\` the ribs go along with a changed spine, else they are searched again; the default is the state of the switch on the page.

A section is \`section: 'star'\` (a preset), \`contours: [[[x, y], …], …]\` (closed curves in any order and size; one within another is a hole) or \`shelf: id\` (a kept one). A region is
\`line\` round the thing (an open one becomes a ribbon), \`contours\` in the same form, or open \`lines\` with a \`width\`.

Every control of the DOM that runs a command carries its id as \`data-command\`.
`;

const kGroups = {
  file: 'Pictures, files, size',
  model: 'Models on this device',
  edit: 'Undo and delete',
  tool: 'Tools',
  part: 'Parts and solids',
  ribs: 'Ribs',
  bone: 'The spine (bone)',
  slice: 'Sections along the spine (slices)',
  board: 'Drawing a section (slice board)',
  look: 'Surface',
  place: 'Placing',
  view: 'Views',
  help: 'Help',
};

/** The exported declarations of a formatted TypeScript file, in order: {kind, name, doc, text}. */
export function declarationsOf(source) {
  const found = [];
  const pattern = /^((?:\/\*\*(?:[^*]|\*(?!\/))*\*\/\n)?)export ((interface|type) (\w+)(?:.*\{\n[^]*?^\}$|[^]*?;$))/gm;
  for (const [, doc, text, kind, name] of source.matchAll(pattern)) found.push({ kind, name, doc: plain(doc), text });
  const exported = source.match(/^export /gm)?.length ?? 0;
  if (found.length !== exported) throw new Error(`api.ts exports ${exported} declarations, ${found.length} were read.`);
  return found;
}

/** The members of an interface: {doc, text}. Every member has a comment of its own, or shares the one before it. */
export function membersOf({ name, text }) {
  const members = [];
  let doc = '';
  for (const line of text.split('\n').slice(1, -1)) {
    const comment = line.match(/^ {2}\/\*\* (.*) \*\/$/);
    const member = line.match(/^ {2}(?:readonly )?(\S.*);$/);
    if (comment) doc = comment[1];
    else if (member) {
      members.push({ doc, text: member[1] });
      doc = '';
    } else throw new Error(`${name}: this line was not read: ${line}`);
  }
  return members;
}

function plain(comment) {
  return comment.replace(/^\/\*\*|\*\/$|^ \* ?/gm, '').trim();
}

/** Text in a cell of a table. */
const cell = (text) => text.replaceAll('|', '\\|');
const code = (text) => (text ? `\`${cell(text)}\`` : '');

function table(head, rows) {
  const lines = [head, head.map(() => '---'), ...rows].map((cells) => `| ${cells.join(' | ')} |`);
  return `${lines.join('\n')}\n`;
}

function commandTables(commands) {
  const unknown = commands.find(({ group }) => !kGroups[group]);
  if (unknown) throw new Error(`The group ${unknown.group} of ${unknown.id} has no title.`);
  return Object.entries(kGroups).map(([group, title]) => {
    const rows = commands
      .filter((command) => command.group === group)
      .map(({ id, arguments: wanted, hint, about }) => [
        code(id),
        code(wanted),
        cell([hint && `${hint}.`, about].filter(Boolean).join(' ')),
      ]);
    return `### ${title}\n\n${table(['id', 'arguments', 'what it does'], rows)}`;
  });
}

/** The page as text. */
export function apiPageText(types, commands) {
  const declarations = declarationsOf(types);
  const api = declarations.find(({ name }) => name === 'SpineLoftApi');
  if (!api) throw new Error('There is no SpineLoftApi.');
  const methods = membersOf(api).map(({ doc, text }) => [code(text), cell(doc)]);
  const others = declarations.filter((one) => one !== api);
  const shown = others.map(({ doc, text }) => (doc ? `/** ${doc.replace(/\s+/g, ' ')} */\n${text}` : text));
  return [
    kIntro,
    `## Methods\n\n${table(['', ''], methods)}`,
    kCommands,
    ...commandTables(commands),
    `## Types\n\n\`\`\`ts\n${shown.join('\n\n')}\n\`\`\`\n`,
  ].join('\n');
}

/** What the page should be now. */
export function currentApiPage() {
  const read = (path) => readFileSync(join(root, path), 'utf8');
  return apiPageText(read('web/shell/api.ts'), JSON.parse(read('assets/docs/commands.json')));
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  writeFileSync(apiPage, currentApiPage());
}
