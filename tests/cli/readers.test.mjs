// Other people's programs read what we write: three.js always, admesh, PrusaSlicer and Blender where they are installed.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { Box3, Mesh, Vector3 } from 'three';
import { unzipSync } from 'three/addons/libs/fflate.module.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';
import { barFolder, works } from '../support/cli.mjs';
import { isImported, isSliced, isWholeToAdmesh, missing } from '../support/readers.mjs';

const kHeight = 40;

/** A bar of 40 mm as a file of this ending; its path. */
function saved(folder, ending) {
  const path = folder.path(`bar.${ending}`);
  works(
    'loft',
    folder.path('bar.png'),
    '--stroke',
    folder.path('stroke.json'),
    '--height-mm',
    String(kHeight),
    '--out',
    path,
  );
  return path;
}

const isHeight = (value, where) => assert.ok(Math.abs(value - kHeight) <= 0.01, `${where}: ${value} mm`);

/** Of three's objects: the size, the number of triangles and the signed volume. */
function measured(object) {
  const size = new Box3().setFromObject(object, true).getSize(new Vector3());
  const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
  let triangles = 0,
    volume = 0;
  object.traverse(({ geometry }) => {
    if (!geometry) return;
    const { position } = (geometry.index ? geometry.toNonIndexed() : geometry).attributes;
    for (let i = 0; i < position.count; i += 3, ++triangles) {
      a.fromBufferAttribute(position, i);
      b.fromBufferAttribute(position, i + 1);
      c.fromBufferAttribute(position, i + 2);
      volume += a.dot(b.cross(c)) / 6;
    }
  });
  return { size, triangles, volume };
}

test('three.js reads an OBJ and an STL as the same solid, as tall as it was asked for', (t) => {
  const folder = barFolder(t);
  const files = unzipSync(new Uint8Array(readFileSync(saved(folder, 'zip'))));
  const name = Object.keys(files).find((file) => file.endsWith('.obj'));
  const obj = measured(new OBJLoader().parse(Buffer.from(files[name]).toString('utf8')));
  const stl = new STLLoader().parse(new Uint8Array(readFileSync(saved(folder, 'stl'))).buffer);
  const solid = measured(new Mesh(stl));
  isHeight(obj.size.y, 'OBJ');
  isHeight(solid.size.z, 'STL');
  assert.ok(obj.triangles > 500);
  assert.equal(solid.triangles, obj.triangles);
  assert.ok(obj.volume > 0);
  assert.ok(Math.abs(solid.volume / obj.volume - 1) < 1e-3, `${solid.volume} and ${obj.volume}`);
});

test('admesh finds an STL whole, and as tall as it was asked for', { skip: missing('admesh') }, async (t) => {
  await isWholeToAdmesh(saved(barFolder(t), 'stl'), kHeight);
});

for (const ending of ['stl', '3mf']) {
  test(`PrusaSlicer measures and slices a ${ending.toUpperCase()}`, { skip: missing('prusa-slicer') }, async (t) => {
    const folder = barFolder(t);
    await isSliced(saved(folder, ending), kHeight, folder.path('bar.gcode'));
  });
}

test('Blender imports a GLB at its size in metres, closed', { skip: missing('blender') }, async (t) => {
  await isImported(saved(barFolder(t), 'glb'), kHeight);
});
