// The light of the viewer: that of the page's own solids (shaders/mesh.frag), as a sphere of radiance that materials of a
// GLB reflect. Small, so that a processor without the graphics' help has it ready at once.
import { DataTexture, EquirectangularReflectionMapping, FloatType, LinearFilter, PMREMGenerator, Vector3 } from 'three';
import type { Texture, WebGLRenderer } from 'three';

const kWidth = 128,
  kHeight = 64;
/** Linear light from below and from above. */
const kGround = [0.28, 0.26, 0.25],
  kSky = [0.54, 0.56, 0.6];
/** The key light over the viewer's left shoulder: its colour on what faces it, and how narrow it is. */
const kKey = new Vector3(-0.45, 0.65, 0.75).normalize(),
  kKeyColour = [0.62, 0.6, 0.57],
  kNarrow = 14;

/** Radiance by direction, as an equirectangular picture. */
function sphere(): DataTexture {
  const pixels = new Float32Array(4 * kWidth * kHeight),
    direction = new Vector3();
  for (let row = 0; row < kHeight; ++row) {
    const height = ((row + 0.5) / kHeight - 0.5) * Math.PI;
    for (let column = 0; column < kWidth; ++column) {
      const round = ((column + 0.5) / kWidth - 0.5) * 2 * Math.PI;
      direction.set(Math.cos(height) * Math.cos(round), Math.sin(height), Math.cos(height) * Math.sin(round));
      const up = 0.5 + 0.5 * direction.y,
        key = (kNarrow / 2) * Math.exp(kNarrow * (direction.dot(kKey) - 1)),
        at = 4 * (row * kWidth + column);
      for (const i of [0, 1, 2]) pixels[at + i] = kGround[i]! * (1 - up) + kSky[i]! * up + kKeyColour[i]! * key;
      pixels[at + 3] = 1;
    }
  }
  const texture = new DataTexture(pixels, kWidth, kHeight, undefined, FloatType);
  texture.mapping = EquirectangularReflectionMapping;
  texture.magFilter = texture.minFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

/** For `Scene.environment`; the viewer looks along −z in it. */
export function studioLight(renderer: WebGLRenderer): Texture {
  const picture = sphere(),
    generator = new PMREMGenerator(renderer);
  const { texture } = generator.fromEquirectangular(picture);
  generator.dispose();
  picture.dispose();
  return texture;
}
