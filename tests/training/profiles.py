"""Width profiles: half width along the middle line, relative to the widest place, and what a thing of that kind
looks like."""

from dataclasses import dataclass

import numpy as np

from spines import wave


@dataclass
class Profile:
    """One drawn profile: `left`, `right` half widths at equal steps of the line (widest 1), ends, and its
    proportions."""

    left: np.ndarray
    right: np.ndarray
    ends: tuple  # of "flat", "round", "point", "open"
    slender: float  # length over greatest width
    turned: bool  # round about its axis: seen from above it has ellipses as ends


COUNT = 240
U = np.linspace(0, 1, COUNT)


def _through(*knots, sharp=1.0):
    """A profile through (place, half width) knots; steps are as steep as the places say."""
    at, wide = np.array(knots, float).T
    blend = np.interp(U, at, np.arange(len(at)))
    low = np.minimum(blend.astype(int), len(at) - 2)
    f = blend - low
    ease = f * f * (3 - 2 * f)
    f = f + (ease - f) * sharp
    return wide[low] * (1 - f) + wide[low + 1] * f


def bottle(r):
    neck, shoulder, length = r.uniform(0.18, 0.5), r.uniform(0.03, 0.25), r.uniform(0.12, 0.4)
    lip = neck * r.uniform(1.0, 1.3)
    top = r.uniform(0.02, 0.05)
    body = _through(
        (0, lip),
        (top, lip),
        (top + 0.005, neck),
        (length, neck * r.uniform(1, 1.3)),
        (min(0.7, length + shoulder), 1),
        (0.94, r.uniform(0.85, 1)),
        (1, r.uniform(0.75, 1)),
    )
    return Profile(body, body, ("flat", "flat"), r.uniform(2.0, 5.0), True)


def vase(r):
    belly = r.uniform(0.3, 0.75)
    mouth, neck, foot = r.uniform(0.3, 0.95), r.uniform(0.2, 0.6), r.uniform(0.25, 0.7)
    body = _through((0, mouth), (r.uniform(0.08, 0.2), min(mouth, neck)), (belly, 1), (0.93, foot * 0.9), (1, foot))
    return Profile(body, body, ("flat", "flat"), r.uniform(1.1, 3.2), True)


def jar(r):
    lid = r.uniform(0.6, 1.0)
    height = r.uniform(0.1, 0.25)
    body = _through(
        (0, lid),
        (height, lid),
        (height + 0.01, lid * r.uniform(0.8, 0.98)),
        (height + 0.1, 1),
        (0.92, 1),
        (1, r.uniform(0.8, 1)),
    )
    return Profile(body, body, ("flat", "flat"), r.uniform(1.0, 2.2), True)


def cup(r):
    body = _through((0, 1), (r.uniform(0.3, 0.7), r.uniform(0.75, 1)), (1, r.uniform(0.45, 1)))
    return Profile(body, body, ("flat", r.choice(["flat", "round"])), r.uniform(0.8, 1.7), True)


def goblet(r):
    bowl, stem = r.uniform(0.3, 0.55), r.uniform(0.06, 0.16)
    body = _through(
        (0, r.uniform(0.6, 0.9)),
        (bowl * 0.5, 1),
        (bowl, stem * 2),
        (bowl + 0.05, stem),
        (0.88, stem),
        (0.96, r.uniform(0.6, 0.95)),
        (1, r.uniform(0.7, 1)),
    )
    return Profile(body, body, ("flat", "flat"), r.uniform(1.6, 2.8), True)


def baluster(r):
    """A turned leg or lamp: rings, coves and steps at random."""
    at = np.sort(r.uniform(0.02, 0.98, r.integers(4, 11)))
    wide = r.uniform(0.25, 1, len(at) + 2)
    body = _through(*zip([0, *at, 1], wide), sharp=r.uniform(0, 1))
    return Profile(body / body.max(), body / body.max(), ("flat", "flat"), r.uniform(2, 7), True)


def steps(r):
    count = r.integers(2, 6)
    edges = np.sort(r.uniform(0.1, 0.9, count - 1))
    body = r.uniform(0.3, 1, count)[np.searchsorted(edges, U)]
    return Profile(body / body.max(), body / body.max(), ("flat", "flat"), r.uniform(1.8, 7), True)


def rod(r):
    body = np.full(COUNT, 1.0)
    return Profile(body, body, (r.choice(["flat", "round"]), r.choice(["flat", "round"])), r.uniform(3, 22), True)


def taper(r):
    body = _through((0, 1), (1, r.uniform(0.1, 0.7)), sharp=0)
    return Profile(body, body, (r.choice(["flat", "round"]), r.choice(["flat", "round"])), r.uniform(2, 10), True)


def tail(r):
    body = (1 - U) ** r.uniform(0.5, 1.1) * (1 + 0.08 * wave(r, COUNT, 8)) + 0.04
    return Profile(
        body / body.max(), body / body.max(), (r.choice(["open", "round"]), "point"), r.uniform(4, 14), False
    )


def neck(r):
    body = _through(
        (0, r.uniform(0.8, 1)),
        (r.uniform(0.3, 0.5), r.uniform(0.35, 0.6)),
        (0.75, r.uniform(0.3, 0.5)),
        (0.9, r.uniform(0.45, 0.8)),
        (1, r.uniform(0.2, 0.4)),
    )
    return Profile(body, body, ("open", "round"), r.uniform(3, 8), False)


def spindle(r):
    body = np.sin(np.pi * U) ** r.uniform(0.4, 1.1) + r.uniform(0.02, 0.2)
    return Profile(body / body.max(), body / body.max(), ("point", "point"), r.uniform(1.8, 8), False)


def pear(r):
    body = _through((0, r.uniform(0.3, 0.5)), (0.3, r.uniform(0.4, 0.65)), (0.7, 1), (1, 0.8))
    return Profile(body, body, ("round", "round"), r.uniform(1.2, 3), False)


def branch(r):
    base = 1 - r.uniform(0, 0.5) * U
    rough = r.uniform(0.03, 0.12)
    left, right = (base * (1 + rough * wave(r, COUNT, r.integers(8, 30))) for _ in range(2))
    most = max(left.max(), right.max())
    ends = (r.choice(["open", "flat", "round"]), r.choice(["open", "round", "point"]))
    return Profile(left / most, right / most, ends, r.uniform(4, 20), False)


def segments(r):
    count = r.integers(3, 12)
    beads = np.abs(np.sin(np.pi * U * count)) ** r.uniform(0.3, 1)
    body = (r.uniform(0.3, 0.8) + beads) * (1 - r.uniform(-0.3, 0.6) * U) * (1 + 0.1 * wave(r, COUNT, 4))
    return Profile(body / body.max(), body / body.max(), ("round", "round"), r.uniform(2.5, 9), False)


def lumpy(r):
    """Two sides that have little to do with each other."""
    left, right = (np.exp(r.uniform(0.15, 0.4) * wave(r, COUNT, r.integers(3, 8))) for _ in range(2))
    most = max(left.max(), right.max())
    return Profile(left / most, right / most, ("round", "round"), r.uniform(1.5, 7), False)


def banana(r):
    body = _through((0, 0.3), (0.08, 0.35), (0.2, 0.85), (0.5, 1), (0.85, 0.8), (0.97, 0.35), (1, 0.25))
    bulge = 1 + r.uniform(0, 0.25)
    return Profile(body / bulge, body, ("flat", "round"), r.uniform(3, 6), False)


FAMILIES = {
    f.__name__: f
    for f in (
        bottle,
        vase,
        jar,
        cup,
        goblet,
        baluster,
        steps,
        rod,
        taper,
        tail,
        neck,
        spindle,
        pear,
        branch,
        segments,
        lumpy,
        banana,
    )
}
TURNED = ("bottle", "vase", "jar", "cup", "goblet", "baluster", "steps")
