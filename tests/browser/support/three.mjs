// A GLB or a 3MF as three.js sees it: loaded by GLTFLoader or 3MFLoader in a blank page of its own.
import { build } from 'esbuild';
import { root } from '../../../.ci/lib/paths.mjs';

const kEntry = `
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { ThreeMFLoader } from 'three/addons/loaders/3MFLoader.js';
import { Box3, Vector3 } from 'three';
/** A loader of 3MF hands over its textures before their pictures are there. */
async function pixelsOf(map) {
  for (let tries = 0; !map.image?.width && tries < 250; tries += 1) await new Promise((done) => setTimeout(done, 20));
  const { width, height } = map.image, canvas = new OffscreenCanvas(width, height), context = canvas.getContext('2d');
  context.drawImage(map.image, 0, 0);
  return { width, height, flipped: map.flipY, data: context.getImageData(0, 0, width, height).data };
}
/** The picture's colour where a triangle has its middle. */
function colourAt({ width, height, flipped, data }, u, v) {
  const x = Math.min(width - 1, Math.floor(u * width)), y = Math.min(height - 1, Math.floor((flipped ? 1 - v : v) * height));
  return [...data.subarray(4 * (y * width + x), 4 * (y * width + x) + 3)];
}
globalThis.measureModel = async (base64, format, wanted) => {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const scene = format === '3mf' ? new ThreeMFLoader().parse(bytes.buffer) : (await new GLTFLoader().parseAsync(bytes.buffer, '')).scene;
  scene.updateMatrixWorld(true);
  const result = { meshes: 0, triangles: 0, volume: 0, textured: false, area: 0, painted: wanted.map(() => 0) };
  const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];
  const objects = [];
  scene.traverse((object) => { if (object.isMesh) objects.push(object); });
  for (const object of objects) {
    result.meshes += 1;
    const { map } = object.material, picture = map ? await pixelsOf(map) : null;
    result.textured ||= Boolean(picture);
    const { index, attributes: { position, uv } } = object.geometry;
    const corner = (i, to) => to.fromBufferAttribute(position, index ? index.getX(i) : i).applyMatrix4(object.matrixWorld);
    const count = index ? index.count : position.count;
    result.triangles += count / 3;
    for (let i = 0; i < count; i += 3) {
      corner(i, a); corner(i + 1, b); corner(i + 2, c);
      const area = b.clone().sub(a).cross(c.clone().sub(a)).length() / 2;
      result.area += area;
      result.volume += a.dot(b.clone().cross(c)) / 6;
      if (!picture) continue;
      const at = (part) => [0, 1, 2].reduce((sum, k) => sum + uv[part](index ? index.getX(i + k) : i + k), 0) / 3;
      const colour = colourAt(picture, at('getX'), at('getY'));
      wanted.forEach((one, k) => { result.painted[k] += Math.hypot(...one.map((x, j) => x - colour[j])) < 30 ? area : 0; });
    }
  }
  result.painted = result.painted.map((area) => area / result.area);
  result.size = new Box3().setFromObject(scene, true).getSize(new Vector3()).toArray();
  return result;
};`;

/** A script for a page, with three.js in it where it asks for that: made when it is first wanted. */
export function scriptOf(contents) {
  let script = null;
  return () => {
    script ??= build({
      stdin: { contents, resolveDir: root, loader: 'js' },
      bundle: true,
      write: false,
      format: 'iife',
      logLevel: 'silent',
    }).then((result) => result.outputFiles[0].text);
    return script;
  };
}

const bundled = scriptOf(kEntry);

/**
 * Meshes, triangles, signed volume, size and whether a texture is on, after three's loader of 'glb' or '3mf'; and of each
 * of these colours how much of the surface has about that one.
 */
export async function loadWithThree(browser, file, format = 'glb', colours = []) {
  const page = await browser.newPage();
  try {
    await page.evaluate(await bundled());
    return await page.evaluate(
      ([data, kind, wanted]) => globalThis.measureModel(data, kind, wanted),
      [file.toString('base64'), format, colours],
    );
  } finally {
    await page.close();
  }
}
