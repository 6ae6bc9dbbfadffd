// The page about the API says what the types and the command table say.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { apiPage, apiPageText, currentApiPage, declarationsOf, membersOf } from '../api_page.mjs';
import { root } from '../lib/paths.mjs';

test('assets/docs/api.md is up to date (node .ci/api_page.mjs writes it)', () => {
  assert.equal(readFileSync(apiPage, 'utf8'), currentApiPage());
});

test('every method and every command is on the page', () => {
  const page = readFileSync(apiPage, 'utf8');
  const types = readFileSync(join(root, 'web/shell/api.ts'), 'utf8');
  const api = declarationsOf(types).find(({ name }) => name === 'SpineLoftApi');
  const names = membersOf(api).map(({ text }) => text.match(/^\w+/)[0]);
  for (const name of ['ready', 'idle', 'run', 'exportModel', 'state']) assert.ok(names.includes(name), name);
  for (const name of names) assert.match(page, new RegExp(`^\\| \`${name}[(:]`, 'm'));
  for (const { id } of JSON.parse(readFileSync(join(root, 'assets/docs/commands.json'), 'utf8')))
    assert.match(page, new RegExp(`^\\| \`${id}\` \\|`, 'm'));
});

test('what cannot be read stops the page instead of being left out', () => {
  const types = '/** An API. */\nexport interface SpineLoftApi {\n  /** Waits. */\n  idle(): Promise<void>;\n}\n';
  const command = { id: 'fit', label: 'Fit', group: 'view', shortcut: 'F', hint: 'Fits', arguments: '{a | b}' };
  const page = apiPageText(types, [command]);
  assert.match(page, /\| `idle\(\): Promise<void>` \| Waits\. \|/);
  assert.match(page, /\| `fit` \| `\{a \\\| b\}` \| Fits\. \|/);
  assert.throws(() => apiPageText(`${types}export const x = 1;\n`, []), /2 declarations, 1/);
  assert.throws(() => apiPageText(types.replace(';', ''), []), /not read/);
  assert.throws(() => apiPageText(types, [{ ...command, group: 'other' }]), /no title/);
});
