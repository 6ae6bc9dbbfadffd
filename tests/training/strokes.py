"""The strokes a person draws along a thing's middle line, from careful to wide of it."""

import numpy as np

from spines import frame, resampled, wave

KINDS = ("careful", "sloppy", "offcentre", "short", "over")


def _stretch(axis, start, end, count):
    """The axis between two shares of its length, straight on beyond its tips: points, normals and widths [count]."""
    arc = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(axis[:, :2], axis=0), axis=1))])
    at = np.linspace(start, end, count) * arc[-1]
    inside = np.clip(at, 0, arc[-1])
    points = np.stack([np.interp(inside, arc, axis[:, k]) for k in (0, 1)], 1)
    tangent, normal = frame(points + 1e-6 * np.arange(count)[:, None])
    first, last = axis[0, :2] - axis[min(6, len(axis) - 1), :2], axis[-1, :2] - axis[-min(7, len(axis)), :2]
    for out, way in ((np.minimum(at, 0), first), (np.maximum(at - arc[-1], 0), last)):
        points = points + np.abs(out)[:, None] * way / max(1e-9, np.linalg.norm(way))
    if start < 0 or end > 1:
        tangent, normal = frame(points)
    return points, normal, np.interp(inside, arc, axis[:, 2])


def strokes_of(r, axis, size):
    """All strokes of a scene of `size` (w, h): careful, sloppy and off-centre always, short and over in a third
    each."""
    kinds = ["careful", "sloppy", "offcentre"] + [k for k in ("short", "over") if r.random() < 0.35]
    return {kind: _inside(stroke(r, axis, kind), size) for kind in kinds}


def _inside(drawn, size):
    """The stroke's longest run in the picture; where none is left, the stroke pushed back into it."""
    inside = ((drawn >= 0) & (drawn <= np.array(size) - 1)).all(1)
    edges = np.flatnonzero(np.diff(np.r_[0, inside.astype(np.int8), 0]))
    a, b = max(zip(edges[::2], edges[1::2]), key=lambda run: run[1] - run[0], default=(0, 0))
    if b - a < 8:
        return np.clip(drawn, 0, np.array(size) - 1)
    return drawn if b - a == len(drawn) else resampled(drawn[a:b], max(2, b - a))


def stroke(r, axis, kind):
    """One stroke [40..120, 2] px. `axis` [n, 3] = middle line and full width from tip to tip."""
    length = np.linalg.norm(np.diff(axis[:, :2], axis=0), axis=1).sum()
    count = int(np.clip(length / 6, 40, 120))
    wide = axis[:, 2].max() / max(length, 1e-9)
    ends = {
        "careful": (0.01, 0.06),
        "sloppy": (0.03, 0.13),
        "offcentre": (0.02, 0.09),
        "short": (0.12, 0.3),
        "over": (-0.12, -0.01),
    }[kind]
    reach = [r.uniform(*ends) for _ in range(2)]
    reach = [min(v, 0.25 * wide + 0.03) if kind == "careful" else v for v in reach]
    points, normal, width = _stretch(axis, reach[0], 1 - reach[1], count)
    side = np.zeros(count)
    if kind in ("careful", "over"):
        side += r.uniform(0.005, 0.02) * wave(r, count, r.integers(3, 7))
    elif kind == "sloppy":
        turns = r.integers(3, 9)
        steepest = 0.3 / (turns * wide)  # a hand sways less on a short thick thing
        side += min(r.uniform(0.04, 0.1), steepest) * np.clip(wave(r, count, turns), -1.3, 1.3)
        side += 0.012 * wave(r, count, 30)
    else:
        away = r.uniform(0.08, 0.33) if kind == "offcentre" else r.uniform(0, 0.1)
        side += r.choice([-1, 1]) * away + r.uniform(0.005, 0.03) * wave(r, count, r.integers(3, 7))
    # Where the width steps, a hand does not: it follows the width smoothly and stays inside the narrower part.
    reach = max(2, count // 14)
    padded = np.pad(width, reach, mode="edge")
    windows = np.lib.stride_tricks.sliding_window_view(padded, 2 * reach + 1)
    smooth = np.convolve(np.pad(windows.min(1), reach, mode="edge"), np.ones(2 * reach + 1) / (2 * reach + 1), "valid")
    drawn = points + normal * np.clip(side, -0.36, 0.36)[:, None] * np.minimum(smooth, width)[:, None]
    return resampled(drawn, count)
