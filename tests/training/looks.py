"""How a thing looks, drawn in strip coordinates: rows along the middle line, columns across, BGR in 0..1."""

from dataclasses import dataclass

import cv2
import numpy as np

import photos
from colours import colour, lab_shift, near, noise
from spines import wave

MATERIALS = ("matte", "gloss", "metal", "glass", "ceramic", "wood", "photo", "fur", "plain", "facets")
REACH = 1.12  # columns run over -REACH .. REACH, the sides being at -1 and 1


@dataclass
class Strip:
    """A picture in strip coordinates and where its rows and columns lie."""

    picture: np.ndarray  # [rows, columns, 3]
    along: np.ndarray  # [rows, 1] in 0..1
    across: np.ndarray  # [1, columns]
    length: float  # px of the line
    half: np.ndarray  # [rows, 1] px
    wet: float = 0.0  # how much of the ground is seen through it


def blank(length, half, base):
    """A strip of one colour, its raster a little finer than the picture's."""
    rows = int(np.clip(length, 48, 1600))
    columns = int(np.clip(half.max() * 2.2, 16, 700))
    along = np.linspace(0, 1, rows, dtype=np.float32)[:, None]
    across = np.linspace(-REACH, REACH, columns, dtype=np.float32)[None]
    half = np.interp(along[:, 0], np.linspace(0, 1, len(half)), half).astype(np.float32)[:, None]
    return Strip(np.tile(np.float32(base), (rows, columns, 1)), along, across, length, half)


def _mix(strip, amount, tone):
    """Lays a colour over the strip, `amount` [rows, columns] in 0..1."""
    strip.picture += amount[..., None] * (np.float32(tone) - strip.picture)


def _around(strip):
    """The angle about the axis, -1..1 from side to side, as on something turned."""
    return np.arcsin(np.clip(strip.across, -1, 1)) * np.float32(2 / np.pi)


# Patterns: each paints something on the strip.


def bands(r, strip, base):
    count = r.integers(1, 9)
    tone = near(r, base, 0.5) if r.random() < 0.5 else colour(r)
    at = strip.along + 0.01 * wave(r, strip.across.size, 3)[None] * r.choice([0, 1]) + 0 * strip.across
    for place, width in zip(r.uniform(0, 1, count), r.uniform(0.004, 0.06, count)):
        _mix(strip, (np.abs(at - place) < width).astype(np.float32) * np.float32(r.uniform(0.5, 1)), tone)


def rings(r, strip, base):
    phase = np.sin(strip.along * (2 * np.pi * r.uniform(6, 40)) + 0 * strip.across)
    _mix(strip, np.clip((phase - r.uniform(-0.5, 0.7)) * 3, 0, 1) * np.float32(r.uniform(0.2, 0.9)), near(r, base, 0.6))


def long_stripes(r, strip, base):
    drift = r.uniform(-4, 4) * strip.along
    phase = np.sin(np.pi * r.uniform(2, 14) * (_around(strip) + 0.2 * drift))
    _mix(strip, np.clip((phase - r.uniform(-0.3, 0.6)) * 5, 0, 1) * np.float32(r.uniform(0.3, 1)), colour(r))


def waves(r, strip, base):
    """Wavy stripes along: paint that looks like an outline."""
    rows = strip.along.size
    tone = colour(r)
    for _ in range(r.integers(1, 5)):
        place = r.uniform(-0.85, 0.85) + r.uniform(0.02, 0.2) * wave(r, rows, r.integers(3, 12))[:, None]
        _mix(strip, (np.abs(strip.across - place) < r.uniform(0.01, 0.12)).astype(np.float32), tone)


def label(r, strip, base):
    """A label with something like print and a picture on it."""
    tone, ink = colour(r), colour(r)
    start = r.uniform(0.1, 0.7)
    end = min(0.97, start + r.uniform(0.1, 0.4))
    side = r.uniform(-1.2, 0.1), r.uniform(0.3, 1.3)
    here = (strip.along > start) & (strip.along < end) & (strip.across > side[0]) & (strip.across < side[1])
    _mix(strip, here.astype(np.float32) * np.float32(r.uniform(0.85, 1)), tone)
    rows, columns = np.nonzero(here.any(1))[0], np.nonzero(here.any(0))[0]
    if len(rows) < 12 or len(columns) < 12:
        return
    paper = np.ascontiguousarray(strip.picture[rows[0] : rows[-1], columns[0] : columns[-1]])
    h, w = paper.shape[:2]
    if r.random() < 0.7:
        cv2.rectangle(
            paper, (int(w * 0.03), int(h * 0.04)), (int(w * 0.97), int(h * 0.96)), ink.tolist(), max(1, h // 60)
        )
    for _ in range(r.integers(1, 7)):
        x, y = int(r.uniform(0, 0.6) * w), int(r.uniform(0.15, 1) * h)
        text = "".join(r.choice(list("abcdefghiklmnoprstuvwABCDEFGHIKLMNOPRSTUVW 0123456789"), r.integers(3, 12)))
        cv2.putText(
            paper,
            text,
            (x, y),
            int(r.integers(0, 8)),
            r.uniform(0.1, 0.5) * h / 40,
            ink.tolist(),
            max(1, h // 60),
            cv2.LINE_AA,
        )
    if r.random() < 0.5:
        cv2.circle(
            paper,
            (int(w * r.uniform(0.2, 0.8)), int(h * r.uniform(0.2, 0.8))),
            int(h * r.uniform(0.1, 0.3)),
            colour(r).tolist(),
            -1,
            cv2.LINE_AA,
        )
    strip.picture[rows[0] : rows[-1], columns[0] : columns[-1]] = paper


def cap(r, strip, base):
    """Another material at one end, with a line where it begins."""
    end = r.uniform(0.05, 0.3)
    at = strip.along if r.random() < 0.5 else 1 - strip.along
    at = at + 0 * strip.across
    _mix(strip, (at < end).astype(np.float32), colour(r))
    _mix(strip, (np.abs(at - end) < 0.006).astype(np.float32) * 0.7, (0.05, 0.05, 0.05))


def spots(r, strip, base):
    field = noise(r, strip.picture.shape[:2], r.uniform(8, 40), 1)
    _mix(strip, np.clip((field - r.uniform(0.4, 1.0)) * 8, 0, 1) * np.float32(r.uniform(0.4, 1)), colour(r))


def grain(r, strip, base):
    field = noise(r, strip.picture.shape[:2], r.uniform(10, 40), 3, (1.0, r.uniform(0.05, 0.3)))
    strip.picture *= (1 + r.uniform(0.05, 0.35) * field)[..., None]


def blotches(r, strip, base):
    field = noise(r, strip.picture.shape[:2], r.uniform(2, 9), 4)
    strip.picture *= (1 + r.uniform(0.05, 0.35) * field)[..., None]


def speckle(r, strip, base):
    strip.picture *= 1 + r.uniform(0.02, 0.2) * r.standard_normal(strip.picture.shape[:2], dtype=np.float32)[..., None]


def checks(r, strip, base):
    u = np.sin(np.pi * r.uniform(3, 9) * _around(strip))
    v = np.sin(np.pi * strip.along * r.uniform(6, 30))
    _mix(strip, (u * v > 0).astype(np.float32) * np.float32(r.uniform(0.3, 1)), colour(r))


def liquid(r, strip, base):
    level = r.uniform(0.2, 0.8)
    _mix(
        strip, (strip.along + 0 * strip.across > level).astype(np.float32) * np.float32(r.uniform(0.5, 0.95)), colour(r)
    )


PATTERNS = {
    f.__name__: f
    for f in (bands, rings, long_stripes, waves, label, cap, spots, grain, blotches, speckle, checks, liquid)
}


def photo_texture(r, strip, side):
    picture = photos.read(r.choice(photos.names(side)))
    h, w = picture.shape[:2]
    size = int(r.uniform(0.15, 0.7) * min(h, w))
    x, y = r.integers(0, w - size), r.integers(0, h - size)
    rows, columns = strip.picture.shape[:2]
    piece = cv2.resize(picture[y : y + size, x : x + size], (columns, rows), interpolation=cv2.INTER_LINEAR)
    strip.picture[:] = piece.astype(np.float32) / 255


# Light.


def _normals(strip, solid, material, r):
    """Across, along and towards the viewer, each [rows, columns]: round, flattened or faceted sections."""
    t = np.clip(strip.across, -1, 1)
    slope = np.gradient(strip.half[:, 0]) / max(1e-6, strip.length / strip.along.size)
    slope = np.clip(slope, -2, 2).astype(np.float32)[:, None]
    if material == "facets":
        sides = r.integers(2, 6)
        edge = np.sort(r.uniform(-0.8, 0.8, sides))
        faces = np.float32(np.linspace(-0.9, 0.9, sides + 1))
        n = faces[np.searchsorted(edge, t[0])][None]
    else:
        n = np.sign(t) * np.abs(t) ** np.float32(r.choice([1, 1, 1, 1.6, 3]))
    z = np.sqrt(np.maximum(0.0, 1 - n * n))
    length = np.sqrt(1 + slope * slope)
    return n / length, -slope / length + 0 * n, z / length


def light(r, strip, solid, material):
    """Shades the strip in place: one or two lights, half-round falling off, highlights, mirrored streaks, rims."""
    across, along, z = _normals(strip, solid, material, r)
    index = np.linspace(0, len(solid.tangent) - 1, strip.along.size).astype(int)
    tangent, normal = solid.tangent[index].astype(np.float32), solid.normal[index].astype(np.float32)
    total = np.full(across.shape, np.float32(r.uniform(0.25, 0.75)))
    shine = np.zeros(across.shape, np.float32)
    hard = {
        "gloss": r.uniform(15, 80),
        "glass": r.uniform(20, 90),
        "ceramic": r.uniform(10, 50),
        "metal": r.uniform(4, 20),
    }
    for _ in range(r.integers(1, 3)):
        angle, height = r.uniform(0, 2 * np.pi), r.uniform(0.15, 0.95)
        flat = np.float32([np.cos(angle), np.sin(angle)]) * np.sqrt(1 - height * height)
        ln, lt = (normal @ flat)[:, None], (tangent @ flat)[:, None]
        lambert = np.clip(across * ln + along * lt + z * np.float32(height), 0, 1)
        total += r.uniform(0.3, 0.9) * lambert
        if material in hard:
            # Half vector of the light and the viewer.
            size = np.sqrt(2 + 2 * height)
            half = np.clip((across * ln + along * lt + z * (height + 1)) / size, 0, 1)
            shine += r.uniform(0.3, 1.0) * half ** np.float32(hard[material])
    strip.picture *= np.minimum(total, 1.5)[..., None]
    if material in ("gloss", "glass", "metal", "ceramic") and r.random() < 0.7:
        shine += _streaks(r, strip, across)
    if material in ("metal",):
        bright = np.interp(across, np.linspace(-1, 1, 14), np.clip(0.5 + 0.5 * r.standard_normal(14), 0, 1.3))
        strip.picture *= (0.35 + bright.astype(np.float32))[..., None]
    if r.random() < 0.35:
        rim = np.clip((np.abs(strip.across) - r.uniform(0.6, 0.93)) * r.uniform(3, 12), 0, 1)
        tone = np.float32([1, 1, 1]) if r.random() < 0.45 else np.float32([0, 0, 0])
        _mix(strip, np.broadcast_to(rim * np.float32(r.uniform(0.15, 0.8)), across.shape), tone)
    strip.picture += shine[..., None] * near(r, np.float32([0.9, 0.9, 0.9]), 0.12)
    np.clip(strip.picture, 0, 1, out=strip.picture)


def _streaks(r, strip, across):
    """Windows and lamps mirrored as bright streaks along the thing, broken where it bends."""
    total = np.zeros(across.shape, np.float32)
    for _ in range(r.integers(1, 4)):
        place = r.uniform(-0.9, 0.9) + 0.05 * wave(r, strip.along.size, 4)[:, None]
        width, start, end = r.uniform(0.02, 0.2), r.uniform(-0.2, 0.6), r.uniform(0.4, 1.2)
        inside = np.clip((width - np.abs(across - place)) / (0.25 * width), 0, 1)
        ends = np.clip((strip.along - start) * 30, 0, 1) * np.clip((end - strip.along) * 30, 0, 1)
        total += np.float32(r.uniform(0.15, 0.9)) * inside.astype(np.float32) * ends
    return total


STRONG = ("bands", "long_stripes", "waves", "label", "cap", "checks", "spots")


def look(r, solid, material, side, base=None, bold=False):
    """A strip with paint and light, `bold` = with strong paint. Returns it and its base colour."""
    base = colour(r) if base is None else base
    if material == "metal":
        base = lab_shift(
            near(r, np.float32([0.6, 0.6, 0.6]), 0.1), r.uniform(-25, 25), r.uniform(-4, 10), r.uniform(-6, 35)
        )
    strip = blank(solid.length, solid.half, base)
    if material == "photo":
        photo_texture(r, strip, side)
    if material == "wood":
        grain(r, strip, base)
    count = {"plain": 0, "photo": 0, "glass": r.integers(0, 3), "wood": r.integers(0, 2)}.get(
        material, r.integers(0, 4)
    )
    for name in r.choice(list(PATTERNS), count):
        PATTERNS[name](r, strip, base)
    if bold:
        for name in r.choice(STRONG, r.integers(1, 4)):
            PATTERNS[name](r, strip, base)
    if material == "fur":
        grain(r, strip, base)
        speckle(r, strip, base)
    if r.random() < 0.4:
        blotches(r, strip, base)
    light(r, strip, solid, material)
    if material == "glass":
        strip.wet = r.uniform(0.35, 0.85)
    return strip, base
