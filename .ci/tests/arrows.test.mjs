import assert from 'node:assert/strict';
import { test } from 'node:test';
import { houseErrors, houseFiles } from '../arrows.mjs';

const of = (path, text) => houseErrors([{ path, text }]);

test('an include against the arrows is caught with its file, line and reason', () => {
  assert.deepEqual(of('engine/base/hash.h', '#pragma once\n#include "engine/ribs/field/d2.h"\n'), [
    'engine/base/hash.h:2: engine/base may not include engine/ribs/field',
  ]);
});

test('an include along the arrows, over several steps or within a folder, is allowed', () => {
  assert.deepEqual(of('engine/loft/loft.cpp', '#include "engine/loft/loft.h"\n#include "engine/base/vec.h"\n'), []);
  assert.deepEqual(
    of('engine/pipeline/derive.cpp', '#include "engine/vision/edges.h"\n#include "engine/mesh/laws.h"\n'),
    [],
  );
  assert.deepEqual(of('web/main.cpp', '#include "web/page/app.h"\n#include "engine/base/result.h"\n'), []);
});

test('siblings without an arrow between them are apart', () => {
  assert.equal(of('engine/io/glb.cpp', '#include "engine/pipeline/derive.h"\n').length, 1);
  assert.equal(of('engine/ribs/search/ribs.cpp', '#include "engine/vision/edges.h"\n').length, 1);
  assert.equal(of('engine/mesh/laws.cpp', '#include "engine/image/image.h"\n').length, 1);
  assert.equal(of('web/gl/mesh.cpp', '#include "web/page/app.h"\n').length, 1);
});

test('nothing in the engine includes the page', () => {
  assert.equal(of('engine/cli/main.cpp', '#include "web/page/app.h"\n').length, 1);
});

test('heavy libraries stay in their box', () => {
  assert.equal(of('engine/ribs/search/ribs.cpp', '#include <opencv2/core.hpp>\n').length, 1);
  assert.deepEqual(of('engine/vision/edges.cpp', '#include <opencv2/core.hpp>\n'), []);
  assert.equal(of('engine/document/document.cpp', '#include <tiny_gltf.h>\n').length, 1);
  assert.equal(of('web/page/app.cpp', '#include <stb_image.h>\n').length, 1);
  assert.equal(of('engine/io/gltf.cpp', '#include <tiny_gltf.h>\n').length, 1);
  assert.deepEqual(of('engine/io/picture_file.cpp', '#include <stb_image.h>\n'), []);
});

test('the engine knows no browser, window or file', () => {
  for (const header of ['emscripten.h', 'GLES3/gl3.h', 'imgui.h', 'GLFW/glfw3.h', 'iostream', 'fstream']) {
    assert.equal(of('engine/loft/loft.cpp', `#include <${header}>\n`).length, 1, header);
  }
  assert.deepEqual(of('engine/cli/files.cpp', '#include <fstream>\n#include <iostream>\n'), []);
});

test('a relative include and an unknown folder are caught', () => {
  assert.equal(of('engine/base/hash.cpp', '#include "hash.h"\n').length, 1);
  assert.equal(of('engine/misc/thing.h', '#pragma once\n').length, 1);
});

test('a file of 601 lines is caught, one of 600 is not', () => {
  assert.equal(of('tests/unit/long.cpp', 'x\n'.repeat(601)).length, 1);
  assert.deepEqual(of('tests/unit/long.cpp', 'x\n'.repeat(600)), []);
});

test('a function of 81 lines is caught where it begins, one of 80 and a longer class are not', () => {
  const body = (count) => '  x();\n'.repeat(count);
  for (const opening of [
    'void f() {',
    'void f(int a,\n       int b) {',
    'export function f(\n  a: string,\n): void {',
    "test('a', () => {",
  ]) {
    const more = opening.split('\n').length - 1;
    const before = opening.startsWith('export') ? more : 0; // its block begins with its last line
    const text = (count) => `int a;\n${opening}\n${body(count - 2 - more + before)}}\n`;
    assert.deepEqual(of('tests/unit/a.ts', text(80)), [], opening);
    assert.deepEqual(
      of('tests/unit/a.ts', text(81)),
      [`tests/unit/a.ts:${2 + before}: a function of 81 lines, at most 80 are allowed`],
      opening,
    );
  }
  assert.deepEqual(of('tests/unit/a.ts', `class A {\n${body(90)}}\n`), []);
});

test('in a script the lines of a function within a function are its own, in C++ they count for both', () => {
  const inner = `  const g = () => {\n${'    x();\n'.repeat(60)}  };\n`;
  const text = `function f() {\n${inner}${inner}}\n`;
  assert.deepEqual(of('tests/unit/a.ts', text), []);
  assert.equal(of('tests/unit/a.cpp', text.replace('function f', 'void f')).length, 1);
  assert.equal(of('tests/unit/a.ts', `function f() {\n${inner}${'  x();\n'.repeat(79)}}\n`).length, 1);
});

test('the house itself keeps its rules', () => {
  assert.deepEqual(houseErrors(houseFiles()), []);
});

test('thread_local is for the one file that is compiled for each program', () => {
  assert.deepEqual(of('tests/unit/a_test.cpp', 'int a;\nthread_local int b = 1;\n'), [
    'tests/unit/a_test.cpp:2: thread_local is for tests/support/scarce_memory.cpp only',
  ]);
  assert.deepEqual(of('tests/support/scarce_memory.cpp', 'thread_local int b = 1;\n'), []);
  const spoken = '// no thread_local\n/* nor\n a thread_local */ int a;\nauto b = "thread_local";\n';
  assert.deepEqual(of('tests/unit/a_test.cpp', spoken), []);
  assert.equal(of('tests/unit/a_test.cpp', `${spoken}int c; thread_local int d; // e\n`).length, 1);
});
