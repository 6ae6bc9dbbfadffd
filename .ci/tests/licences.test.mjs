// Nothing is shipped that LICENSES.md does not name, with the text of its licence.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { libraryOf, licenceFaults, packagesOf } from '../lib/licences.mjs';
import { root } from '../lib/paths.mjs';

const text = readFileSync(join(root, 'assets/LICENSES.md'), 'utf8'),
  texts = readdirSync(join(root, 'assets/licences'));
const kLinked = [
  { name: 'OpenCV', version: '4.10.0' },
  { name: 'Eigen', version: null },
  { name: 'manifold-3d', version: '3.5.4' },
];
const faults = (change) => licenceFaults({ libraries: kLinked, modules: ['core'], text, texts, ...change });

test('what is linked or bundled must be named, in its version and with a text', () => {
  assert.deepEqual(faults({}), []);
  const other = [{ name: 'left-pad', version: '1.0.0' }];
  assert.deepEqual(faults({ libraries: other }), ['left-pad is part of the site and not named.']);
  const newer = [{ name: 'manifold-3d', version: '3.6.0' }];
  assert.deepEqual(faults({ libraries: newer }), ['manifold-3d is version 3.6.0, not 3.5.4.']);
  assert.match(
    faults({ text: text.replace('| Eigen 3 | [MPL 2.0](licences/MPL-2.0.txt)', '| Eigen 3 | MPL 2.0') })[0],
    /no text/,
  );
  assert.deepEqual(faults({ modules: ['core', 'video'] }), [
    'The module video of OpenCV is part of the site and not named.',
  ]);
});

test('every licence that is named has its text, and every text is the licence of something', () => {
  assert.match(faults({ texts: texts.filter((file) => file !== 'OFL-1.1.txt') })[0], /OFL-1\.1\.txt is missing/);
  assert.match(faults({ texts: [...texts, 'GPL-3.0.txt'] })[0], /GPL-3\.0\.txt is the licence of nothing/);
  for (const file of texts) assert.ok(readFileSync(join(root, 'assets/licences', file)).length > 500, file);
});

test('files are known by where they are: the own ones, those of the set-up, npm packages, and any other by its path', () => {
  assert.equal(libraryOf(join(root, 'engine/base/result.h')), null);
  assert.equal(libraryOf('/another/checkout/build/wasm-release/headers-0e3a5b3df990.h'), null);
  assert.deepEqual(libraryOf('/x/opencv-4.10.0-wasm-12/lib/libopencv.a'), { name: 'OpenCV', version: '4.10.0' });
  assert.deepEqual(libraryOf('/usr/include/zlib.h'), { name: '/usr/include/zlib.h', version: null });
  const [idb, inter] = packagesOf(['node_modules/idb/build/index.js', 'node_modules/@expo-google-fonts/inter/a.ttf']);
  assert.equal(idb.name, 'idb');
  assert.equal(inter.name, '@expo-google-fonts/inter');
});
