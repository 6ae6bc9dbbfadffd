"""What is behind: photographs and made grounds, BGR float32 in 0..1 of the size asked for."""

import cv2
import numpy as np

import photos
from colours import colour, near, noise


def photo(r, size, side):
    """A random piece of a photograph, mirrored, brightened, sometimes out of focus. Returns it and its name."""
    w, h = size
    name = r.choice(photos.names(side))
    picture = photos.read(name)
    share = r.uniform(0.35, 1.0)
    height, width = picture.shape[:2]
    cut = min(width, height * w / h) * share
    cut_w, cut_h = max(8, int(cut)), max(8, int(cut * h / w))
    x, y = r.integers(0, width - cut_w + 1), r.integers(0, max(1, height - cut_h + 1))
    piece = picture[y : y + cut_h, x : x + cut_w]
    piece = piece[:, ::-1] if r.random() < 0.5 else piece
    out = cv2.resize(piece, size, interpolation=cv2.INTER_AREA if cut_w > w else cv2.INTER_LINEAR)
    out = out.astype(np.float32) * np.float32(1 / 255)
    if r.random() < 0.4:
        sigma = r.uniform(0.002, 0.015) * max(size)
        out = cv2.GaussianBlur(out, (0, 0), sigma) if sigma < 3 else soft(out, sigma)
    return np.clip((out - 0.5) * r.uniform(0.6, 1.15) + 0.5 + r.uniform(-0.12, 0.12), 0, 1), f"photo:{name}"


def soft(picture, sigma):
    """A wide Gaussian by way of a smaller picture."""
    scale = min(1.0, 2.5 / sigma)
    small = cv2.resize(picture, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)
    small = cv2.GaussianBlur(small, (0, 0), sigma * scale)
    return cv2.resize(small, picture.shape[1::-1], interpolation=cv2.INTER_LINEAR)


def _plane(size, tone):
    return np.tile(np.float32(tone), (size[1], size[0], 1))


def _lit(r, picture, strength):
    """Uneven light over a ground."""
    h, w = picture.shape[:2]
    corner = r.uniform(1 - strength, 1 + strength * 0.4, (2, 2)).astype(np.float32)
    return np.clip(picture * cv2.resize(corner, (w, h), interpolation=cv2.INTER_LINEAR)[..., None], 0, 1)


def studio(r, size):
    out = _plane(size, colour(r) if r.random() < 0.5 else np.full(3, r.uniform(0.3, 1)))
    if r.random() < 0.6:  # a table's edge
        y = int(size[1] * r.uniform(0.45, 0.9))
        out[y:] = near(r, out[0, 0], 0.25)
        out = cv2.GaussianBlur(out, (0, 0), r.uniform(0.5, 12))
    return _lit(r, out, 0.5)


def wall(r, size):
    out = _plane(size, colour(r))
    out *= (1 + r.uniform(0.03, 0.2) * noise(r, out.shape[:2], r.uniform(4, 120), 3))[..., None]
    if r.random() < 0.5:  # bricks
        w, h = size
        tall = h / r.uniform(5, 22)
        wide = tall * r.uniform(1.6, 3.2)
        y, x = np.mgrid[0:h, 0:w].astype(np.float32)
        row = np.floor(y / tall)
        gap = (np.mod(y, tall) < tall * 0.1) | (np.mod(x + (row % 2) * wide / 2, wide) < tall * 0.1)
        tone = 1 + 0.2 * np.sin(row * 12.9898 + np.floor((x + (row % 2) * wide / 2) / wide) * 78.233)
        out *= tone[..., None]
        out[gap] = near(r, out.mean((0, 1)), 0.35)
    return _lit(r, out, 0.4)


def planks(r, size):
    w, h = size
    out = _plane(size, near(r, np.float32([0.25, 0.42, 0.62]), 0.25))
    along = r.random() < 0.5
    shape = (h, w) if along else (w, h)
    texture = noise(r, shape, r.uniform(6, 30), 4, (0.12, 1.5))
    edges = np.sort(r.uniform(0, shape[0], r.integers(2, 9))).astype(int)
    tone = np.zeros(shape, np.float32)
    for a, b in zip([0, *edges], [*edges, shape[0]]):
        tone[a:b] = r.uniform(-0.25, 0.2)
        tone[max(0, a - 1) : a + 1] = -0.7
        texture[a:b] = np.roll(texture[a:b], int(r.integers(0, shape[1])), 1)
    both = 1 + tone + r.uniform(0.05, 0.3) * texture
    return _lit(r, np.clip(out * (both if along else both.T)[..., None], 0, 1), 0.4)


def clutter(r, size):
    """Many things, out of focus or not: boxes, discs, rods, papers."""
    out = studio(r, size)
    w, h = size
    for _ in range(r.integers(10, 70)):
        tone = colour(r).tolist()
        centre = (int(r.uniform(0, w)), int(r.uniform(0, h)))
        far = r.uniform(0.02, 0.2) * max(size)
        kind = r.random()
        if kind < 0.35:
            corners = cv2.boxPoints((centre, (far * r.uniform(0.5, 2.5), far), r.uniform(0, 180)))
            cv2.fillPoly(out, [np.int32(corners)], tone, cv2.LINE_AA)
            if r.random() < 0.4:
                cv2.polylines(out, [np.int32(corners)], True, colour(r).tolist(), r.integers(1, 4), cv2.LINE_AA)
        elif kind < 0.6:
            cv2.ellipse(
                out, centre, (int(far), int(far * r.uniform(0.3, 1))), r.uniform(0, 180), 0, 360, tone, -1, cv2.LINE_AA
            )
        elif kind < 0.85:
            other = (int(r.uniform(0, w)), int(r.uniform(0, h)))
            cv2.line(out, centre, other, tone, int(r.integers(1, max(2, int(0.03 * w)))), cv2.LINE_AA)
        else:
            text = "".join(r.choice(list("abcdefghinoprstuABCDEFG 0123456789"), r.integers(3, 12)))
            cv2.putText(
                out, text, centre, int(r.integers(0, 8)), r.uniform(0.4, 3), tone, r.integers(1, 4), cv2.LINE_AA
            )
    if r.random() < 0.6:
        out = soft(out, max(0.6, r.uniform(0.001, 0.012) * w))
    return _lit(r, out * (1 + 0.06 * noise(r, (h, w), 30, 3))[..., None], 0.5)


def meadow(r, size):
    """Grass, leaves, gravel, sand, water: coloured noise of several sizes, sometimes stretched."""
    w, h = size
    base, other = colour(r), None
    other = near(r, base, 0.4)
    field = noise(r, (h, w), r.uniform(6, 90), 4, (1.0, r.choice([1.0, 1.0, 0.3, 3.0])))
    mix = np.clip(0.5 + r.uniform(0.3, 1.0) * field, 0, 1)[..., None]
    out = np.float32(base) * mix + np.float32(other) * (1 - mix)
    return _lit(r, np.clip(out, 0, 1), 0.5)


def cloth(r, size):
    w, h = size
    out = _plane(size, colour(r))
    y, x = np.mgrid[0:h, 0:w].astype(np.float32)
    angle, period = r.uniform(0, np.pi), r.uniform(6, 0.1 * w + 8)
    u = (x * np.cos(angle) + y * np.sin(angle)) * np.float32(2 * np.pi / period)
    v = (-x * np.sin(angle) + y * np.cos(angle)) * np.float32(2 * np.pi / period)
    if r.random() < 0.5:
        mask = np.sin(u) > r.uniform(-0.6, 0.6)
    else:
        mask = (np.sin(u) > 0) ^ (np.sin(v) > 0)
    out[mask] = near(r, out[0, 0], r.uniform(0.1, 0.7))
    folds = noise(r, (h, w), r.uniform(2, 8), 2, (1.0, r.uniform(0.2, 1)))
    return np.clip(out * (1 + r.uniform(0.05, 0.3) * folds)[..., None], 0, 1)


def tiles(r, size):
    w, h = size
    out = _plane(size, colour(r))
    side = max(w, h) / r.uniform(3, 12)
    y, x = np.mgrid[0:h, 0:w].astype(np.float32)
    cell = np.sin(np.floor(x / side) * 127.1 + np.floor(y / side) * 311.7)
    out *= (1 + 0.12 * cell)[..., None]
    out[(np.mod(x, side) < side * 0.05) | (np.mod(y, side) < side * 0.05)] = near(r, out[0, 0], 0.4)
    return _lit(r, np.clip(out, 0, 1), 0.5)


MADE = {f.__name__: f for f in (studio, wall, planks, clutter, meadow, cloth, tiles)}


def paper(r, size):
    """Paper for drawings: white to brown, grain, creases, ruled or squared; now and then a photo of it in poor
    light."""
    w, h = size
    tone = np.float32([1, 1, 1]) if r.random() < 0.4 else np.float32([0.9, 0.95, 0.97]) * r.uniform(0.75, 1.02)
    if r.random() < 0.16:
        tone = colour(r)
    out = _plane(size, np.clip(tone, 0, 1))
    if r.random() < 0.25:
        line = near(r, np.float32([0.85, 0.75, 0.65]), 0.1)
        step = r.uniform(14, 45)
        for at in np.arange(r.uniform(0, step), h, step):
            cv2.line(out, (0, int(at)), (w, int(at)), line.tolist(), 1, cv2.LINE_AA)
        if r.random() < 0.5:
            for at in np.arange(r.uniform(0, step), w, step):
                cv2.line(out, (int(at), 0), (int(at), h), line.tolist(), 1, cv2.LINE_AA)
    if r.random() < 0.6:
        out *= (1 + r.uniform(0.01, 0.07) * noise(r, (h, w), r.uniform(40, 250), 2))[..., None]
    if r.random() < 0.4:
        out = _lit(r, out, r.uniform(0.1, 0.5))
    return np.clip(out, 0, 1)
