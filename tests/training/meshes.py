"""Meshes for renders: a line swept with a round section, closed at its ends or open and hollow. Arrays only, no
Blender."""

import numpy as np

AROUND = 56


def sweep(line, side, up, right, left, height=1.0, bulge_ends=True):
    """A tube about `line` [n, 3]: `side`, `up` [n, 3] unit vectors across, half widths to either side [n], and the
    height of the section over its width. Returns (vertices [m, 3], quads [k, 4], uv [m, 2])."""
    angle = np.linspace(-np.pi, np.pi, AROUND + 1)  # the seam, uv 0 and 1, lies at the back
    c, s = np.sin(angle), np.cos(angle)
    wide = np.where(c[None] > 0, right[:, None], left[:, None])
    half = (right + left) / 2
    points = (
        line[:, None]
        + side[:, None] * (c[None] * wide)[..., None]
        + up[:, None] * (s[None] * half[:, None] * height)[..., None]
    )
    n, k = points.shape[:2]
    arc = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(line, axis=0), axis=1))])
    uv = np.stack(np.broadcast_arrays(np.linspace(0, 1, k)[None], (arc / max(arc[-1], 1e-9))[:, None]), 2)
    index = np.arange(n * k).reshape(n, k)
    quads = np.stack([index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]], 2).reshape(-1, 4)
    vertices, coordinates = points.reshape(-1, 3), uv.reshape(-1, 2)
    if bulge_ends:  # close both ends with a fan around their centres
        for at in (0, n - 1):
            centre = len(vertices)
            vertices = np.concatenate([vertices, line[at : at + 1]])
            coordinates = np.concatenate([coordinates, [[0.5, float(at > 0)]]])
            ring = index[at]
            fan = np.stack([ring[:-1], ring[1:], np.full(k - 1, centre), np.full(k - 1, centre)], 1)
            quads = np.concatenate([quads, fan[:, ::-1] if at else fan])
    return vertices, quads, coordinates


def turned(profile, length, radius, wall=None):
    """A thing turned about the z axis, its start on top: `profile` [n] half widths relative to `radius`. With `wall`
    (share of the radius) it is a vessel, open on top."""
    n = len(profile)
    z = np.linspace(length, 0, n)
    outer = profile * radius
    if wall:
        inner = np.maximum(outer - wall * radius, 0.02 * radius)
        stop = max(4, int(n * 0.96))
        z_in, r_in = z[:stop][::-1], inner[:stop][::-1]
        z, outer = np.concatenate([z_in, z]), np.concatenate([r_in, outer])
    line = np.stack([0 * z, 0 * z, z], 1)
    side, up = np.tile([1.0, 0, 0], (len(z), 1)), np.tile([0, -1.0, 0], (len(z), 1))
    vertices, quads, uv = sweep(line, side, up, outer, outer)
    uv[: len(z) * (AROUND + 1), 1] = np.repeat(1 - z / length, AROUND + 1)
    return vertices, quads, uv
