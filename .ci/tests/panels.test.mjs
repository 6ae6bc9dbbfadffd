// What the panels on the canvas call a command, and when it can be used, is what its row of the command table says.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { root } from '../lib/paths.mjs';

const folder = join(root, 'web/panels');
const sources = readdirSync(folder)
  .filter((file) => file.endsWith('.cpp'))
  .map((file) => ({ file, text: readFileSync(join(folder, file), 'utf8') }));
const table = JSON.parse(readFileSync(join(root, 'assets/docs/commands.json'), 'utf8'));

test('a panel runs a command of the table through a widget that takes words and enabledness from its row', () => {
  const widgets = sources.find(({ file }) => file === 'widgets.cpp');
  assert.match(widgets.text, /sink\.run\(command\)/);
  for (const { file, text } of sources) {
    if (file === 'widgets.cpp') continue;
    const own = [...text.matchAll(/sink\.run\((?:"[\w-]+"|\*|(?:app::)?commandOf)[^;]*/g)].map(([call]) => call);
    // The next step of a sketch is the tool that draws, in the words of that step.
    assert.deepEqual(own, file === 'sketch_bar.cpp' ? ['sink.run("draw")'] : [], file);
  }
});

test('no button of a panel repeats the words of a row', () => {
  const words = new Set(table.flatMap(({ label, hint }) => [label, hint]));
  let buttons = 0;
  for (const { file, text } of sources)
    for (const [call] of text.matchAll(/\b(?:iconButton|textButton|namedButton|menuRow|command\w+)\(env, [^;]*/g)) {
      buttons += 1;
      for (const [, literal] of call.matchAll(/"([^"]*)"/g)) assert.ok(!words.has(literal), `${file}: ${literal}`);
    }
  assert.ok(buttons > 30, `${buttons} buttons`);
});
