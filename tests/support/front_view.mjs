// What is seen of a saved model from the front, drawn here pixel by pixel and held against its picture. Runs in Node and in
// a page. A mesh is {positions, uv, corners, picture}: places with y up and +z to the viewer, UV with v down, three corners
// a triangle, and {width, height, data} in RGBA, or null. Pictures have y down and pixel centres at integers.

/** A triangle's pixels: `visit(x, y, weights)` for every centre within it and within width × height, whichever way round it runs. */
function rasterize([[ax, ay], [bx, by], [cx, cy]], width, height, visit) {
  const area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  if (Math.abs(area) < 1e-12) return;
  const left = Math.max(0, Math.ceil(Math.min(ax, bx, cx))),
    right = Math.min(width - 1, Math.floor(Math.max(ax, bx, cx)));
  const top = Math.max(0, Math.ceil(Math.min(ay, by, cy))),
    bottom = Math.min(height - 1, Math.floor(Math.max(ay, by, cy)));
  for (let y = top; y <= bottom; y += 1) {
    for (let x = left; x <= right; x += 1) {
      const b = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / area,
        c = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / area,
        a = 1 - b - c;
      if (a >= 0 && b >= 0 && c >= 0) visit(x, y, [a, b, c]);
    }
  }
}

const mixed = (weights, values) => weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2];
const cornersOf = ({ corners }, i) => [corners[i], corners[i + 1], corners[i + 2]];

/** The four texels around a place between texel centres, the atlas' edge repeated. */
function bilinear({ width, height, data }, u, v, to, at) {
  const x = Math.min(width - 1, Math.max(0, u * width - 0.5)),
    y = Math.min(height - 1, Math.max(0, v * height - 0.5));
  const x0 = Math.floor(x),
    y0 = Math.floor(y),
    x1 = Math.min(x0 + 1, width - 1),
    y1 = Math.min(y0 + 1, height - 1),
    fx = x - x0,
    fy = y - y0;
  for (let c = 0; c < 3; c += 1) {
    const texel = (px, py) => data[4 * (py * width + px) + c];
    to[at + c] =
      (texel(x0, y0) * (1 - fx) + texel(x1, y0) * fx) * (1 - fy) + (texel(x0, y1) * (1 - fx) + texel(x1, y1) * fx) * fy;
  }
}

/**
 * Seen along −z, at one pixel of the picture a pixel: {colours, owner}, three numbers a pixel and the index of the mesh that is
 * seen there, −1 for none. `place` is where the picture lies in the model: {scale, left, top}, units a pixel and the place of the centre of pixel (0, 0).
 */
export function frontView(meshes, { width, height }, { scale, left, top }) {
  const colours = new Float32Array(3 * width * height),
    owner = new Int32Array(width * height).fill(-1),
    depth = new Float64Array(width * height).fill(-Infinity);
  meshes.forEach((mesh, index) => {
    const { positions, uv, corners, picture } = mesh;
    for (let i = 0; i < corners.length; i += 3) {
      const own = cornersOf(mesh, i),
        outline = own.map((k) => [(positions[3 * k] - left) / scale, (top - positions[3 * k + 1]) / scale]);
      rasterize(outline, width, height, (x, y, weights) => {
        const at = y * width + x,
          z = mixed(
            weights,
            own.map((k) => positions[3 * k + 2]),
          );
        if (z <= depth[at]) return;
        depth[at] = z;
        owner[at] = index;
        if (picture)
          bilinear(
            picture,
            mixed(
              weights,
              own.map((k) => uv[2 * k]),
            ),
            mixed(
              weights,
              own.map((k) => uv[2 * k + 1]),
            ),
            colours,
            3 * at,
          );
      });
    }
  });
  return { width, height, colours, owner };
}

/** 1 where `inside(i)` holds at a pixel and its eight neighbours. */
export function withoutRim({ width, height }, inside) {
  const out = new Uint8Array(width * height);
  for (let y = 1; y + 1 < height; y += 1) {
    for (let x = 1; x + 1 < width; x += 1) {
      const at = y * width + x,
        around = [-width - 1, -width, -width + 1, -1, 0, 1, width - 1, width, width + 1];
      out[at] = around.every((step) => inside(at + step)) ? 1 : 0;
    }
  }
  return out;
}

/** How like the picture a view is over the pixels in which `inside(i)` holds: {decibels, pixels}. */
export function likeness({ colours, owner }, { data }, inside) {
  let sum = 0,
    pixels = 0;
  for (let i = 0; i < owner.length; i += 1) {
    if (owner[i] < 0 || !inside(i)) continue;
    pixels += 1;
    for (let c = 0; c < 3; c += 1) sum += (colours[3 * i + c] - data[4 * i + c]) ** 2;
  }
  return { decibels: pixels === 0 ? 0 : 10 * Math.log10(255 ** 2 / Math.max(1e-9, sum / (3 * pixels))), pixels };
}

/** Least and greatest texel coordinate of a mesh's used UV, texel centres at integers. */
function texelBox({ uv, corners, picture: { width, height } }) {
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (const k of corners) {
    const x = uv[2 * k] * width - 0.5,
      y = uv[2 * k + 1] * height - 0.5;
    ((box[0] = Math.min(box[0], x)),
      (box[1] = Math.min(box[1], y)),
      (box[2] = Math.max(box[2], x)),
      (box[3] = Math.max(box[3], y)));
  }
  return box;
}

/** Texels between two boxes, along the axis on which they are farther apart; less than 0: they overlap. */
const between = (a, b) => Math.max(b[0] - a[2], a[0] - b[2], b[1] - a[3], a[1] - b[3]);

/**
 * How used texels lie in their atlas: {least, greatest} UV, and of meshes that share no texel how far `apart` they are at the
 * least; `bare`: texels within `reach` of a used one that are white where nothing used near them is, as unpadded ones would be.
 */
export function atlasUse(meshes, reach) {
  const [{ picture }] = meshes,
    { width, height, data } = picture,
    used = new Uint8Array(width * height);
  let least = Infinity,
    greatest = -Infinity,
    apart = Infinity;
  const boxes = meshes.map(texelBox);
  for (const mesh of meshes) {
    for (const k of mesh.corners) {
      least = Math.min(least, mesh.uv[2 * k], mesh.uv[2 * k + 1]);
      greatest = Math.max(greatest, mesh.uv[2 * k], mesh.uv[2 * k + 1]);
    }
    const texel = (k) => [mesh.uv[2 * k] * width - 0.5, mesh.uv[2 * k + 1] * height - 0.5];
    for (let i = 0; i < mesh.corners.length; i += 3)
      rasterize(cornersOf(mesh, i).map(texel), width, height, (x, y) => {
        used[y * width + x] = 1;
      });
  }
  boxes.forEach((a, i) =>
    boxes.slice(0, i).forEach((b) => {
      if (between(a, b) > 0) apart = Math.min(apart, between(a, b));
    }),
  );
  return { width, height, least, greatest, apart, bare: bareAround(used, { width, height, data }, reach) };
}

function bareAround(used, { width, height, data }, reach) {
  const kWhite = 247,
    kNearlyWhite = 200;
  const palest = (i) => Math.min(data[4 * i], data[4 * i + 1], data[4 * i + 2]);
  let bare = 0;
  for (let y = 0; y < height; y += 1) {
    for (let x = 0; x < width; x += 1) {
      if (used[y * width + x] || palest(y * width + x) < kWhite) continue;
      let near = false,
        alike = false;
      for (let v = Math.max(0, y - reach); v <= Math.min(height - 1, y + reach); v += 1) {
        for (let u = Math.max(0, x - reach); u <= Math.min(width - 1, x + reach); u += 1) {
          if (!used[v * width + u]) continue;
          near = true;
          alike ||= palest(v * width + u) >= kNearlyWhite;
        }
      }
      bare += near && !alike ? 1 : 0;
    }
  }
  return bare;
}

/** Where the picture lies in a model of which two points are known, in the picture and in the model: {scale, left, top} as frontView wants it. */
export function placeOf([[ax, ay], [bx, by]], [[au, av], [bu, bv]]) {
  // Of the two axes the one along which the points are farther apart says more.
  const scale = Math.abs(bx - ax) > Math.abs(by - ay) ? (bu - au) / (bx - ax) : (av - bv) / (by - ay);
  return { scale, left: (au + bu - scale * (ax + bx)) / 2, top: (av + bv + scale * (ay + by)) / 2 };
}
