// The catalogues of assets/words hold exactly the texts of the page, each with the same arguments, in every language.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { IntlMessageFormat } from 'intl-messageformat';
import shapers from 'arabic-persian-reshaper';
import { scriptFont, scriptLanguages } from '../lib/fonts.mjs';
import { root } from '../lib/paths.mjs';
import { catalogue, catalogueIds, pageWords } from '../lib/words.mjs';
import { openFont } from './support/font_reader.mjs';

const found = pageWords();
const catalogues = new Map(catalogueIds().map((id) => [id, catalogue(id)]));
const source = (path) => readFileSync(join(root, path), 'utf8');

/** Names in braces, in the English of the code and anywhere in a message. */
const namesIn = (english) => new Set([...english.matchAll(/\{(\w+)\}/g)].map(([, name]) => name));
function argumentsOf(nodes, names = new Set()) {
  for (const node of nodes) {
    if (node.type !== 0 && node.type !== 7) names.add(node.value);
    for (const { value } of Object.values(node.options ?? {})) argumentsOf(value, names);
  }
  return names;
}
const parse = (message, id) => new IntlMessageFormat(message, id, {}, { ignoreTag: true });

test('texts are found wherever the page has them', () => {
  const where = {
    'That file is empty. Choose a photo or a drawing.': 'an error of the engine',
    'Rounded square': 'a table of the engine',
    'Draw one line along the middle of the thing': 'the command table',
    'Smoothing of the bone': 'the parameter table',
    'Neighbours follow within {n} hundredths of the bone.': 'a sentence with an argument',
    'on an edge': 'a small word that is marked',
    'Press Save to keep it as a file': 'the tasks',
    'Draw a line. Get a solid.': 'index.html',
    'A quick drawing': 'the samples',
    'no part yet': 'a call of t()',
  };
  for (const [text, what] of Object.entries(where)) assert.ok(found.has(text), `${what}: ${text}`);
  assert.ok(found.size > 900, `${found.size} texts`);
});

test('what only programs read is no text of the page', () => {
  for (const text of ['Puff by numbers', 'NotNow', 'spineloft.language', 'Content-Type'])
    assert.ok(!found.has(text), text);
});

test('the page offers the languages of the catalogues, and English', () => {
  const ids = ['en', ...catalogues.keys()].sort();
  const inShell = [...source('web/shell/words/words.ts').matchAll(/\{ id: '(\w+)', name: '([^']+)'/g)];
  const inCanvas = [...source('web/words/words.cpp').matchAll(/Known\{"(\w+)",\s*"([^"]+)"\}/g)];
  assert.deepEqual(inShell.map(([, id]) => id).sort(), ids);
  assert.deepEqual(
    inCanvas.map(([, id, name]) => [id, name]),
    inShell.map(([, id, name]) => [id, name]),
  );
});

/** Labels of commands that a sentence names: with a capital, and not as its first word. */
const labels = [...JSON.parse(source('assets/docs/commands.json')).map(({ label }) => label), 'Save', 'More'];
const namedIn = (sentence) =>
  labels.filter((label) => new RegExp(`[a-z,] ${label}(?![\\w"])`).test(sentence) && found.has(label));

for (const [id, messages] of catalogues) {
  test(`${id}: a sentence that names a command has its words in quotation marks`, () => {
    const sentences = [...source('web/shell/tasks.ts').matchAll(/(?:say|start): '([^']+)'/g)].map(([, text]) => text);
    const named = sentences.flatMap((text) => namedIn(text).map((label) => [text, messages[label]]));
    assert.ok(named.length > 8, `${named.length}`);
    for (const [text, label] of named)
      assert.match(messages[text], new RegExp(`[„«「]\\u00a0?${label}\\u00a0?[“»」]`), text);
  });

  test(`${id}: every text of the page has a message, and every message is of a text`, () => {
    const missing = [...found].filter(([text]) => !messages[text]?.trim());
    const unused = Object.keys(messages).filter((text) => !found.has(text));
    assert.deepEqual(
      { missing: missing.map(([text, path]) => `${path}: ${text}`), unused },
      { missing: [], unused: [] },
    );
  });

  test(`${id}: a message has the arguments of its text, and says something for every number`, () => {
    for (const [text, message] of Object.entries(messages)) {
      const format = parse(message, id);
      const names = namesIn(text);
      assert.deepEqual([...argumentsOf(format.getAst())].sort(), [...names].sort(), `${text} → ${message}`);
      for (const n of [0, 1, 2, 3, 11, 100, 1.5]) {
        const given = Object.fromEntries([...names].map((name) => [name, name === 'n' ? n : `[${name}]`]));
        const spoken = String(format.format(given));
        assert.doesNotMatch(spoken, /[{}]|undefined/, `${text} → ${message}`);
        for (const name of names)
          if (name !== 'n') assert.ok(spoken.includes(`[${name}]`), `${text}, ${n} → ${spoken}`);
      }
    }
  });

  test(`${id}: a message that is a text of the page, too, is its own translation`, () => {
    // What was translated may be shown by something that translates.
    for (const [text, message] of Object.entries(messages))
      if (messages[message] !== undefined) assert.equal(messages[message], message, `${text} → ${message}`);
  });

  test(`${id}: a sentence that names a button calls it as the button says`, () => {
    let quoted = 0;
    for (const [text, message] of Object.entries(messages))
      for (const [, name] of text.matchAll(/"([^"]+)"/g)) {
        if (!messages[name]) continue;
        quoted += 1;
        assert.ok(message.includes(messages[name]), `${text} → ${message}: ${messages[name]}`);
      }
    assert.ok(quoted >= 8, `${quoted} names`);
  });
}

for (const id of scriptLanguages) {
  test(`${id}: its fonts have every letter of the catalogue that Inter lacks, as it is written and as it is drawn`, async () => {
    const text = Object.values(catalogues.get(id)).join(' ');
    const letters = [...text, ...shapers.ArabicShaper.convertArabic(text)].filter((letter) =>
      /[^\0-\u05ff\u2000-\u206f]/.test(letter),
    );
    assert.ok(new Set(letters).size > 80);
    for (const weight of ['text', 'bold']) {
      const { codes, outline } = openFont(await scriptFont(id, weight));
      const drawn = (code) => codes.has(code) && outline(code).length > 0;
      const without = [...new Set(letters)].filter((letter) => !drawn(letter.codePointAt(0)));
      assert.deepEqual(without, [], weight);
    }
  });
}
