// Links of the documents lead somewhere, and the sections that comments cite exist.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import test from 'node:test';
import { houseFiles } from '../arrows.mjs';
import { root } from '../lib/paths.mjs';

const kPages = ['README.md', 'CONTRIBUTING.md', 'CHANGELOG.md'].concat(
  [
    'accuracy',
    'api',
    'architecture',
    'command-line',
    'glossary',
    'guide',
    'hosting',
    'lesson',
    'data-protection',
    'method',
    'viewer',
  ].map((name) => `assets/docs/${name}.md`),
);
const read = (path) => readFileSync(join(root, path), 'utf8');

test('every link of a document leads to a file', () => {
  let links = 0;
  for (const page of kPages) {
    for (const [, target] of read(page).matchAll(/\]\(([^)\s]+)\)/g)) {
      if (/^(https?:|#)/.test(target)) continue;
      ++links;
      assert.ok(existsSync(join(root, dirname(page), target.split('#')[0])), `${page}: ${target}`);
    }
  }
  assert.ok(links > 20, `${links} links`);
});

test('the sections of the method page that comments cite exist', () => {
  const titles = [...read('assets/docs/method.md').matchAll(/^#{2,3} (?:\d+ )?(.+)$/gm)].map(([, title]) => title);
  let cited = 0;
  for (const { path, text } of houseFiles().filter((file) => /^(engine|web)\/.*\.(h|cpp)$/.test(file.path))) {
    const prose = text.replace(/\n\s*\/\/+ ?/g, ' ');
    for (const [, list] of prose.matchAll(/method: ((?:"[^"]+"(?:, )?)+)/g)) {
      for (const [, title] of list.matchAll(/"([^"]+)"/g)) {
        ++cited;
        const known = titles.some((one) => one === title || one.startsWith(`${title}:`));
        assert.ok(known, `${path} cites "${title}"`);
      }
    }
  }
  assert.ok(cited > 10, `${cited} citations`);
});
