// A saved GLB seen from the front as three.js loads it, held against the picture that it was made from.
import { scriptOf } from './three.mjs';

const kEntry = `
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { atlasUse, frontView, likeness, placeOf, withoutRim } from './tests/support/front_view.mjs';

const bytesOf = (base64) => Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));

function pixelsOf(bitmap) {
  const { width, height } = bitmap, context = new OffscreenCanvas(width, height).getContext('2d');
  context.drawImage(bitmap, 0, 0);
  return { width, height, data: context.getImageData(0, 0, width, height).data };
}
const decoded = async (base64) => pixelsOf(await createImageBitmap(new Blob([bytesOf(base64)]), { colorSpaceConversion: 'none', premultiplyAlpha: 'none' }));

const nodeOf = (scene, object) => (object.parent === scene ? object : nodeOf(scene, object.parent));

/** The meshes of a GLB in its own metres, each with its node's name, and how many images are in the file. */
async function meshesOf(base64) {
  const { scene, parser } = await new GLTFLoader().parseAsync(bytesOf(base64).buffer, '');
  scene.updateMatrixWorld(true);
  const objects = [], pictures = new Map();
  scene.traverse((object) => { if (object.isMesh) objects.push(object); });
  const meshes = objects.map((object) => {
    const { map } = object.material, { position, uv } = object.geometry.attributes;
    if (map && !pictures.has(map.source.uuid)) pictures.set(map.source.uuid, pixelsOf(map.image));
    return {
      name: nodeOf(scene, object).name, uv: uv?.array, corners: object.geometry.index.array, picture: map ? pictures.get(map.source.uuid) : null,
      positions: position.clone().applyMatrix4(object.matrixWorld).array,
    };
  });
  return { meshes, images: parser.json.images?.length ?? 0, drawn: pictures.size };
}

/** Least and greatest x and y of some meshes. */
function boundsOf(meshes) {
  const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
  for (const { positions } of meshes) {
    for (let i = 0; i < positions.length; i += 1) {
      if (i % 3 === 2) continue;
      low[i % 3] = Math.min(low[i % 3], positions[i]);
      high[i % 3] = Math.max(high[i % 3], positions[i]);
    }
  }
  return [low, high];
}

globalThis.seeFromFront = async ({ glb, picture, mask, known, reach }) => {
  const { meshes, images, drawn } = await meshesOf(glb), shown = await decoded(picture), thing = mask ? await decoded(mask) : null;
  // What is known of the picture's place: meshes by their names and where they are in it, upside down for y is down there.
  const [low, high] = boundsOf(known.meshes ? meshes.filter(({ name }) => known.meshes.includes(name)) : meshes);
  const seen = meshes.filter(({ name }) => !known.meshes?.includes(name));
  const [[left, top], [right, bottom]] = known.box;
  const view = frontView(seen, shown, placeOf([[left, bottom], [right, top]], [low, high]));
  const isThing = (i) => thing === null || thing.data[4 * i] >= 200;
  const inner = withoutRim(view, (i) => view.owner[i] >= 0 && isThing(i));
  return {
    images, drawn, plain: meshes.filter((mesh) => !mesh.picture).length, ...atlasUse(meshes.filter((mesh) => mesh.picture), reach),
    size: [shown.width, shown.height], within: likeness(view, shown, (i) => inner[i]), whole: likeness(view, shown, isThing),
  };
};`;

const bundled = scriptOf(kEntry);

/** A blank page that looks at files; `look` as often as there are any, then `close`. */
export async function frontViewer(browser) {
  const page = await browser.newPage();
  await page.evaluate(await bundled());
  const text = (bytes) => bytes?.toString('base64');
  return {
    look: ({ glb, picture, mask, known, reach = 6 }) =>
      page.evaluate((all) => globalThis.seeFromFront(all), {
        glb: text(glb),
        picture: text(picture),
        mask: text(mask),
        known,
        reach,
      }),
    close: () => page.close(),
  };
}
