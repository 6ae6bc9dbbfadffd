// Other people's programs that read models: admesh, PrusaSlicer and Blender, where they are installed.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';

/** Why a test cannot run here, or false. */
export function missing(name) {
  const found = spawnSync('sh', ['-c', `command -v ${name}`]).status === 0;
  return found ? false : `${name} is not installed (apt-get install ${name})`;
}

/** What a reader says of a file, on both of its outputs; the process is not held up meanwhile. */
export async function said(name, ...args) {
  const reader = spawn(name, args, { timeout: 300_000 });
  let text = '';
  for (const stream of [reader.stdout, reader.stderr])
    stream.setEncoding('utf8').on('data', (more) => {
      text += more;
    });
  const status = await new Promise((resolve, reject) => {
    reader.on('error', reject);
    reader.on('close', resolve);
  });
  assert.equal(status, 0, `${name}: ${text.slice(-3000)}`);
  return text;
}

const number = (text, pattern) => Number(text.match(pattern)?.[1]);
const isHeight = (value, wanted, where) => assert.ok(Math.abs(value - wanted) <= 0.01, `${where}: ${value} mm`);

/** admesh has nothing to mend about an STL: one closed outward solid, `millimetres` tall. */
export async function isWholeToAdmesh(stl, millimetres) {
  const report = await said('admesh', stl);
  isHeight(number(report, /Max Z =\s*([\d.]+)/) - number(report, /Min Z =\s*(-?[\d.]+)/), millimetres, 'STL');
  const faults = [
    'Total disconnected facets',
    'Degenerate facets',
    'Edges fixed',
    'Facets removed',
    'Facets added',
    'Facets reversed',
    'Backwards edges',
  ];
  for (const fault of faults) assert.equal(number(report, new RegExp(`${fault}\\s*:\\s*(\\d+)`)), 0, report);
  assert.equal(number(report, /Number of parts\s*:\s*(\d+)/), 1, report);
  assert.ok(number(report, /Volume\s*:\s*(-?[\d.]+)/) > 0);
}

/** PrusaSlicer finds one closed solid in an STL or a 3MF, `millimetres` tall, and slices it. */
export async function isSliced(file, millimetres, code) {
  const info = await said('prusa-slicer', '--info', file);
  isHeight(number(info, /size_z = ([\d.]+)/), millimetres, file);
  assert.match(info, /manifold = yes/);
  assert.equal(number(info, /number_of_parts = +(\d+)/), 1, info);
  await said('prusa-slicer', '--export-gcode', '--output', code, file);
  const moves = readFileSync(code, 'utf8')
    .split('\n')
    .filter((line) => /^G1 .*E/.test(line));
  assert.ok(moves.length > 500, `${moves.length} moves`);
}

/** Blender imports a GLB as one solid without open edges, `millimetres` tall. */
export async function isImported(glb, millimetres) {
  const script = [
    // Debian's Blender 3.4 asks its numpy 1.24 for a name that this one no longer has.
    'import bpy, bmesh, numpy',
    'numpy.bool = bool',
    "bpy.ops.object.select_all(action='SELECT')",
    'bpy.ops.object.delete()',
    `bpy.ops.import_scene.gltf(filepath=${JSON.stringify(glb)})`,
    "meshes = [o for o in bpy.data.objects if o.type == 'MESH']",
    'heights = [(o.matrix_world @ v.co).z for o in meshes for v in o.data.vertices]',
    "print('SIZE', max(heights) - min(heights))",
    'whole = bmesh.new()',
    'for o in meshes:',
    '  part = o.data.copy()',
    '  part.transform(o.matrix_world)',
    '  whole.from_mesh(part)',
    // Corners that differ in their texture alone are one; places are floats of metres.
    'bmesh.ops.remove_doubles(whole, verts=whole.verts, dist=1e-7)',
    "print('OPEN', sum(1 for e in whole.edges if not e.is_manifold))",
    "print('VOLUME', whole.calc_volume(signed=True))",
  ].join('\n');
  const report = await said('blender', '--background', '--factory-startup', '--python-expr', script);
  isHeight(1000 * number(report, /SIZE ([\d.]+)/), millimetres, 'GLB');
  assert.equal(number(report, /OPEN (\d+)/), 0, report);
  assert.ok(number(report, /VOLUME (-?[\d.e-]+)/) > 0, report);
}
