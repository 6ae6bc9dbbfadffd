// A GLB or a 3MF as three.js sees it: loaded by GLTFLoader or 3MFLoader in a blank page of its own.
import { build } from 'esbuild';
import { root } from '../../../.ci/lib/paths.mjs';

const kEntry = `
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { ThreeMFLoader } from 'three/addons/loaders/3MFLoader.js';
import { Box3, Vector3 } from 'three';
globalThis.measureModel = async (base64, format) => {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const scene = format === '3mf' ? new ThreeMFLoader().parse(bytes.buffer) : (await new GLTFLoader().parseAsync(bytes.buffer, '')).scene;
  scene.updateMatrixWorld(true);
  const result = { meshes: 0, triangles: 0, volume: 0, textured: false };
  const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
  scene.traverse((object) => {
    if (!object.isMesh) return;
    result.meshes += 1;
    result.textured ||= Boolean(object.material.map?.image?.width);
    const { index, attributes: { position } } = object.geometry;
    const corner = (i, to) => to.fromBufferAttribute(position, index ? index.getX(i) : i).applyMatrix4(object.matrixWorld);
    const count = index ? index.count : position.count;
    result.triangles += count / 3;
    for (let i = 0; i < count; i += 3) {
      corner(i, a); corner(i + 1, b); corner(i + 2, c);
      result.volume += a.dot(b.cross(c)) / 6;
    }
  });
  result.size = new Box3().setFromObject(scene, true).getSize(new Vector3()).toArray();
  return result;
};`;

let script = null;

async function bundled() {
  script ??= build({
    stdin: { contents: kEntry, resolveDir: root, loader: 'js' }, bundle: true, write: false, format: 'iife', logLevel: 'silent',
  }).then((result) => result.outputFiles[0].text);
  return script;
}

/** Meshes, triangles, signed volume, size and whether a texture is on, after three's loader of 'glb' or '3mf'. */
export async function loadWithThree(browser, file, format = 'glb') {
  const page = await browser.newPage();
  try {
    await page.evaluate(await bundled());
    return await page.evaluate(([data, kind]) => globalThis.measureModel(data, kind), [file.toString('base64'), format]);
  } finally {
    await page.close();
  }
}
