// Bridges from outside: recipes in, files and reports out; what a solver makes of them.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import Module from 'manifold-3d';
import { fails, readJson, workFolder, works } from '../support/cli.mjs';

const kBadRecipe = 3;
const example = fileURLToPath(new URL('../../assets/docs/recipes/bridges.json', import.meta.url));
const library = await Module();
library.setup();
const { Manifold, Mesh } = library;

/** A circle on a ball of the recipe below, round the place where `way` leaves it. */
function rimOn([x, y], size, way, radius) {
  const length = Math.hypot(...way);
  const out = way.map((value) => value / length);
  const up = [-out[1], out[0], 0].map((value) => value / Math.hypot(out[0], out[1]));
  const far = Math.sqrt((size / 2) ** 2 - radius ** 2);
  const side = [out[1] * up[2] - out[2] * up[1], out[2] * up[0] - out[0] * up[2], out[0] * up[1] - out[1] * up[0]];
  return Array.from({ length: 16 }, (_, i) => {
    const [c, s] = [Math.cos((Math.PI * i) / 8) * radius, Math.sin((Math.PI * i) / 8) * radius];
    return [x, -y, 0].map((centre, axis) => centre + out[axis] * far + up[axis] * c + side[axis] * s);
  }).flat();
}
const ball = (id, [x, y], size) => ({
  id,
  kind: 'shape',
  recipe: {
    picture: 1,
    axis: [
      [x, y + size / 2],
      [x, y - size / 2],
    ],
    width: size,
  },
});
/** Two balls with a gap, and a bridge between them. */
const twoBalls = (bridge = {}) => ({
  pictures: [{ id: 1, size: [600, 400] }],
  parts: [
    ball(1, [150, 200], 200),
    ball(2, [450, 180], 160),
    {
      id: 3,
      kind: 'bridge',
      recipe: {
        picture: 1,
        from: { part: 1, rim: rimOn([150, 200], 200, [1, 0.07, 0], 45) },
        to: { part: 2, rim: rimOn([450, 180], 160, [-1, -0.07, 0], 40) },
        ...bridge,
      },
    },
  ],
});

const make = (folder, recipe) => {
  writeFileSync(folder.path('recipe.json'), JSON.stringify(recipe));
  const [obj, report] = [folder.path('made.obj'), folder.path('report.json')];
  works('make', '--recipe', folder.path('recipe.json'), '--out', obj, '--report', report);
  return { parts: readJson(report).parts, solids: solidsOf(readFileSync(obj, 'utf8')) };
};

/** The parts of an OBJ as solids of manifold-3d, in pixels of the ball that is 200 wide. */
function solidsOf(text) {
  const places = [];
  const parts = [];
  for (const line of text.split('\n')) {
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === 'o' || word === 'g') parts.push([]);
    if (word === 'v') places.push(rest.slice(0, 3).map(Number));
    if (word === 'f') parts.at(-1).push(rest.map((corner) => Number(corner.split('/')[0]) - 1));
  }
  return parts
    .filter((triangles) => triangles.length > 0)
    .map((triangles) => {
      const known = new Map();
      const vertProperties = [];
      const triVerts = triangles.flat().map((index) => {
        const key = places[index].join(' ');
        if (!known.has(key)) {
          known.set(key, known.size);
          vertProperties.push(...places[index]);
        }
        return known.get(key);
      });
      return new Manifold(
        new Mesh({ numProp: 3, vertProperties: new Float32Array(vertProperties), triVerts: new Uint32Array(triVerts) }),
      );
    });
}

/** The largest angles, in degrees, between neighbours of a solid: of edges near to a rim, and of the others. */
function sharpest(solid, centre, radius) {
  const { vertProperties: v, triVerts: t } = solid.getMesh();
  const at = (i) => [v[3 * i], v[3 * i + 1], v[3 * i + 2]];
  const minus = (a, b) => a.map((value, axis) => value - b[axis]);
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const normals = new Map();
  const most = { near: 0, far: 0 };
  for (let i = 0; i < t.length; i += 3) {
    const corners = [t[i], t[i + 1], t[i + 2]];
    const [a, b, c] = corners.map(at);
    const n = cross(minus(b, a), minus(c, a));
    const size = Math.hypot(...n);
    // What is thinner than a thousandth of the rim has no direction to speak of.
    const edge = Math.max(Math.hypot(...minus(b, a)), Math.hypot(...minus(c, b)), Math.hypot(...minus(a, c)));
    if (size / edge < 1e-3 * radius) continue;
    const normal = n.map((value) => value / size);
    corners.forEach((from, k) => {
      const to = corners[(k + 1) % 3];
      const other = normals.get(`${to} ${from}`);
      normals.set(`${from} ${to}`, normal);
      if (!other) return;
      const angle =
        (Math.acos(
          Math.min(
            1,
            Math.max(
              -1,
              normal.reduce((s, x, j) => s + x * other[j], 0),
            ),
          ),
        ) *
          180) /
        Math.PI;
      const middle = at(from).map((value, axis) => (value + at(to)[axis]) / 2);
      const place = Math.hypot(...minus(middle, centre)) < 1.15 * radius ? 'near' : 'far';
      most[place] = Math.max(most[place], angle);
    });
  }
  return most;
}

test('two balls and their bridge are one piece without a handle, as smooth at the rims as beside them', (t) => {
  const folder = workFolder(t);
  const { parts, solids } = make(folder, twoBalls());
  assert.ok(parts[2].lawful && parts[2].genus === 0 && parts[2].shells === 1, parts[2].broken);
  assert.equal(parts[2].rims.length, 2);
  const [from, to] = parts[2].rims;
  assert.ok(Math.abs(from.radius - 45) < 1 && Math.abs(to.radius - 40) < 1);
  const off = ({ centre, radius }, [x, y], size) =>
    Math.abs(Math.hypot(centre[0] - x, centre[1] + y, centre[2]) - Math.sqrt((size / 2) ** 2 - radius ** 2));
  assert.ok(off(from, [150, 200], 200) < 0.5 && off(to, [450, 180], 160) < 0.5);
  const apart = Manifold.union(solids.slice(0, 2));
  assert.equal(apart.decompose().length, 2);
  const whole = Manifold.union(solids);
  assert.equal(whole.decompose().length, 1);
  assert.equal(whole.genus(), 0);
  // In the file all is scaled and shifted: the first ball says how.
  const box = solids[0].boundingBox();
  const scale = (box.max[0] - box.min[0]) / 200;
  const middle = box.min.map((low, axis) => (low + box.max[axis]) / 2);
  const place = from.centre.map((value, axis) => middle[axis] + (value - [150, -200, 0][axis]) * scale);
  const edges = sharpest(whole, place, from.radius * scale);
  const facets = sharpest(solids[0], place, from.radius * scale).near;
  assert.ok(edges.near < facets + 4, `${edges.near}: facets ${facets}`);
});

test('a handle adds one to the genus of what it stands on, and a bridge follows a part that is moved and turned', (t) => {
  const folder = workFolder(t);
  const handle = twoBalls();
  handle.parts[2].recipe.from.rim = rimOn([150, 200], 200, [-0.8, 0.6, 0], 16);
  handle.parts[2].recipe.to = { part: 1, rim: rimOn([150, 200], 200, [-0.8, -0.6, 0], 16) };
  const { solids } = make(folder, handle);
  assert.equal(Manifold.union([solids[0], solids[2]]).genus(), 1);
  const moved = twoBalls();
  moved.parts[1].placement = { pivot: [0.25, 0, 0], move: [0.1, 0.2, 0.1], turn: [0.9659258, 0, 0, 0.258819] };
  const after = make(folder, moved);
  const whole = Manifold.union(after.solids);
  assert.equal(whole.decompose().length, 1);
  assert.equal(whole.genus(), 0);
});

test('the bridges of the guide are lawful', (t) => {
  const folder = workFolder(t);
  works('make', '--recipe', example, '--out', folder.path('bridges.glb'), '--report', folder.path('report.json'));
  for (const part of readJson(folder.path('report.json')).parts) {
    assert.ok(part.lawful && part.genus === 0 && part.shells === 1, `${part.name}: ${part.broken}`);
  }
});

test('a bridge alone, without its part, on another bridge, or with a rim of two places is refused with a sentence', (t) => {
  const folder = workFolder(t);
  const refused = (recipe) => {
    writeFileSync(folder.path('bad.json'), JSON.stringify(recipe));
    return fails(kBadRecipe, 'make', '--recipe', folder.path('bad.json'), '--out', folder.path('bad.obj'));
  };
  assert.match(refused(twoBalls().parts[2]), /a bridge needs the parts that it joins/);
  const short = twoBalls();
  short.parts[2].recipe.to.rim = [1, 2, 3, 4, 5, 6];
  assert.match(refused(short), /rim/);
  const wide = twoBalls({ waist: 2 });
  assert.match(refused(wide), /waist/);
  for (const part of [9, 3]) {
    const gone = twoBalls();
    gone.parts[2].recipe.to.part = part;
    writeFileSync(folder.path('gone.json'), JSON.stringify(gone));
    const said = fails(kBadRecipe, 'make', '--recipe', folder.path('gone.json'), '--out', folder.path('gone.obj'));
    assert.match(said, /A part that this bridge stands on has no solid/);
  }
});
