"""Middle lines. A family is a curvature along the line: turning angles (radians) of equal steps, integrated to
points."""

import numpy as np

STEPS = 160


def _smooth(values, width):
    """Values with a Gaussian of `width` steps passed over them."""
    reach = int(3 * width) + 1
    kernel = np.exp(-0.5 * (np.arange(-reach, reach + 1) / width) ** 2)
    return np.convolve(np.pad(values, reach, mode="edge"), kernel / kernel.sum(), mode="valid")


def wave(r, count, roughest):
    """A smooth random function of `count` values, about unit variance, with features of 1/roughest of its length."""
    knots = r.standard_normal(max(4, int(roughest) + 3))
    rough = np.interp(np.linspace(0, len(knots) - 1, count), np.arange(len(knots)), knots)
    return 1.35 * _smooth(rough, count / (1.7 * len(knots)))


def _share(turn, angle):
    return turn * (angle / max(1e-9, np.abs(turn).sum()))


def straight(r):
    return _share(1 + 0.5 * wave(r, STEPS, 2), np.radians(r.uniform(0, 14)))


def bend(r):
    return _share(np.abs(1 + 0.6 * wave(r, STEPS, 3)), np.radians(r.uniform(25, 165)))


def elbow(r):
    at, width = r.uniform(0.25, 0.75), r.uniform(0.04, 0.12)
    return _share(np.exp(-0.5 * ((np.linspace(0, 1, STEPS) - at) / width) ** 2), np.radians(r.uniform(40, 120)))


def s_shape(r):
    u = np.linspace(0, 1, STEPS)
    middle = r.uniform(0.35, 0.65)
    return _share(np.tanh((u - middle) / 0.12) * (1 + 0.3 * wave(r, STEPS, 3)), np.radians(r.uniform(110, 330)))


def hook(r):
    u = np.linspace(0, 1, STEPS)
    start = r.uniform(0.3, 0.6)
    return _share(1 / (1 + np.exp(-(u - start) / 0.03)) + 0.04, np.radians(r.uniform(140, 240)))


def ring(r):
    return _share(1 + 0.15 * wave(r, STEPS, 3), np.radians(r.uniform(220, 318)))


def serpentine(r):
    waves = r.integers(2, 6)
    u = np.linspace(0, waves * np.pi, STEPS)
    return _share(np.sin(u + r.uniform(0, 1)) * (1 + 0.25 * wave(r, STEPS, 4)), waves * np.radians(r.uniform(90, 200)))


def wander(r):
    return _share(wave(r, STEPS, r.integers(3, 9)), np.radians(r.uniform(120, 520)))


def spiral(r):
    u = np.linspace(0, 1, STEPS)
    return _share(1 / (1.15 - u), np.radians(r.uniform(330, 560)))


FAMILIES = {f.__name__: f for f in (straight, bend, elbow, s_shape, hook, ring, serpentine, wander, spiral)}


def points_of(turns, r):
    """Unit-length polyline [STEPS + 1, 2] of the turns, in a random direction, mirrored at random."""
    heading = np.concatenate([[0], np.cumsum(turns)]) * r.choice([-1, 1])
    steps = np.stack([np.cos(heading), np.sin(heading)], 1)[:-1] / STEPS
    return np.concatenate([[[0, 0]], np.cumsum(steps, 0)])


def resampled(points, count):
    """The polyline with `count` points at equal arc length."""
    arc = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    at = np.linspace(0, arc[-1], count)
    return np.stack([np.interp(at, arc, points[:, 0]), np.interp(at, arc, points[:, 1])], 1)


def frame(points):
    """Unit tangents and normals of a polyline."""
    tangent = np.gradient(points, axis=0)
    tangent /= np.maximum(1e-9, np.linalg.norm(tangent, axis=1, keepdims=True))
    return tangent, np.stack([-tangent[:, 1], tangent[:, 0]], 1)
