"""Things of random lines and profiles, as solids that stand in a picture."""

import numpy as np

import profiles
import spines
from solids import Solid, room

UNIT_STEPS = 220
SLENDEREST = 45  # length over width


def unit_thing(r, spine, profile):
    """A thing of one family with a line one unit long that does not touch itself: (points, left, right, profile)."""
    while True:
        shape = profiles.FAMILIES[profile](r)
        unit = spines.points_of(spines.FAMILIES[spine](r), r)
        turn = r.uniform(0, 2 * np.pi)
        if shape.turned and spine == "straight" and r.random() < 0.75:  # such things stand
            turn = np.pi / 2 + np.radians(r.normal(0, 8)) + (np.pi if r.random() < 0.1 else 0)
            unit = unit @ rotation(-np.arctan2(*(unit[-1] - unit[0])[::-1])).T
        unit = spines.resampled(unit @ rotation(turn).T, UNIT_STEPS)
        slender = shape.slender * r.uniform(0.8, 1.25)
        if spine in ("serpentine", "spiral", "wander", "ring"):
            slender = max(slender, r.uniform(8, 26))
        place = np.linspace(0, 1, UNIT_STEPS)
        left, right = (np.interp(place, profiles.U, v) / (2 * slender) for v in (shape.left, shape.right))
        while not room(unit, left, right) and slender < SLENDEREST:
            left, right, slender = left * 0.88, right * 0.88, slender / 0.88
        if not shape.turned and r.random() < 0.2:  # grows out of something
            shape.ends = ("open", shape.ends[1])
        if slender < SLENDEREST:
            left, right = (rounded(v, shape.ends, 1 / UNIT_STEPS) for v in (left, right))
            return unit, left, right, shape


def extent(thing):
    """The box (low, high) of a unit thing."""
    unit, left, right, _ = thing
    _, normal = spines.frame(unit)
    sides = np.concatenate([unit - normal * left[:, None], unit + normal * right[:, None]])
    return sides.min(0), sides.max(0)


def placed(r, thing, size, scale=None):
    """The solid of a unit thing: nearly as large as the picture allows, or `scale` of that and anywhere."""
    unit, left, right, shape = thing
    low, high = extent(thing)
    w, h = size
    fill = scale if scale else 1 - 0.42 * r.random() ** 1.6
    factor = fill * 0.98 * min(w / (high[0] - low[0]), h / (high[1] - low[1]))
    if scale is None and r.random() < 0.13:
        solid = _reaching_out(r, thing, size, factor * r.uniform(1.15, 1.9))
        if solid:
            return solid
    spare = np.array([w, h]) - factor * (high - low)
    start = r.uniform(0.1, 0.9, 2) * spare if scale is None else r.uniform(-0.2, 1.2, 2) * spare
    return _sized(r, thing, factor, start - low * factor)


def _reaching_out(r, thing, size, factor):
    """The thing so large and so placed that it leaves the picture at one end; None where that leaves too little."""
    for _ in range(6):
        tip = thing[0][r.choice([0, -1])] * factor
        solid = _sized(r, thing, factor, r.uniform(0.08, 0.92, 2) * np.array(size) - tip, flat=True)
        if 0.45 < solid.cut(size) < 0.97 and solid.ends.count("cut") == 1:
            return solid
    return None


def _sized(r, thing, factor, start, flat=False):
    """A solid from a unit thing: `factor` px a unit, moved by `start`, mostly at least 5 px wide."""
    unit, left, right, shape = thing
    factor_across = factor * max(1.0, 5 / max(1e-6, factor * np.median(left + right)))
    points = unit * factor + start
    count = int(np.clip(np.linalg.norm(np.diff(points, axis=0), axis=1).sum() / 2.5, 90, 900))
    points = spines.resampled(points, count)
    left, right = (
        np.interp(np.linspace(0, 1, count), np.linspace(0, 1, UNIT_STEPS), v) * factor_across for v in (left, right)
    )
    seen_from_above = (
        shape.turned and not flat and np.ptp(spines.frame(points)[0], axis=0).max() < 0.5 and r.random() < 0.8
    )
    bulge = r.uniform(0.03, 0.38) * r.choice([-1, 1]) if seen_from_above else 0
    return Solid(points, left, right, bulge, shape.ends)


def make_solid(r, size, spine, profile, scale=None):
    return placed(r, unit_thing(r, spine, profile), size, scale)


def rotation(angle):
    return np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])


def rounded(half, ends, step):
    """Round and pointed ends close over a length of about the half width."""
    half = half.copy()
    for at, end in ((0, ends[0]), (-1, ends[1])):
        if end in ("round", "point"):
            reach = half[0 if at == 0 else -1] * (1.0 if end == "round" else 2.2) + 2 * step
            distance = np.arange(len(half)) * step
            distance = distance if at == 0 else distance[::-1]
            f = np.clip(distance / max(reach, 1e-9), 0, 1)
            half *= np.sqrt(np.maximum(0, 1 - (1 - f) ** 2)) if end == "round" else f**0.8
    return np.maximum(half, 1e-5)
