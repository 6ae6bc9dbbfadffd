// What hangs together in a mesh, by the numbers of its vertices.

/** For every vertex one that stands for its piece; pieces are what edges join. */
export function rootsOf(vertices: number, triangles: ArrayLike<number>): Uint32Array {
  const root = new Uint32Array(vertices);
  for (let v = 0; v < vertices; v += 1) root[v] = v;
  for (let i = 0; i < triangles.length; i += 1) {
    // Every corner with the first one of its triangle.
    const c = i % 3;
    if (c === 0) continue;
    let a = triangles[i - c]!,
      b = triangles[i]!;
    while (root[a] !== a) a = root[a] = root[root[a]!]!;
    while (root[b] !== b) b = root[b] = root[root[b]!]!;
    root[a] = b;
  }
  for (let v = 0; v < vertices; v += 1) {
    let r = v;
    while (root[r] !== r) r = root[r] = root[root[r]!]!;
    root[v] = r;
  }
  return root;
}

/** How many pieces a closed mesh has, and how many handles on all of them. */
export function countOf(vertices: number, triangles: ArrayLike<number>): { pieces: number; handles: number } {
  const root = rootsOf(vertices, triangles),
    used = new Uint8Array(vertices);
  for (let i = 0; i < triangles.length; i += 1) used[triangles[i]!] = 1;
  let pieces = 0,
    corners = 0;
  for (let v = 0; v < vertices; v += 1) {
    corners += used[v]!;
    if (used[v] && root[v] === v) pieces += 1;
  }
  // Euler: a piece has corners − edges + faces = 2 − 2 · handles, and one and a half edges a face.
  return { pieces, handles: pieces - (corners - triangles.length / 6) / 2 };
}
