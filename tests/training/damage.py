"""What happens to a picture: outlines that disappear, things in front, camera and file."""

import cv2
import numpy as np

from colours import colour, near, noise
from grounds import soft
from spines import wave


def pieces(r, count, share):
    """Which of `count` outline points go: `share` of them, in pieces of different length."""
    gone = np.zeros(count, bool)
    for _ in range(40):
        if gone.mean() >= share:
            break
        size = int(count * min(share - gone.mean() + 0.01, r.uniform(0.04, 0.25))) + 2
        start = r.integers(0, count)
        gone[np.arange(start, start + size) % count] = True
    return gone


def _runs(gone):
    """Index runs of a boolean ring-less list."""
    edges = np.flatnonzero(np.diff(np.r_[0, gone.astype(np.int8), 0]))
    return zip(edges[::2], edges[1::2])


def _weight(shape, polyline, reach, softness):
    """A soft band along a polyline, float32 [h, w] in 0..1."""
    scale = min(1.0, 8 / max(reach, 1))
    small = np.zeros((max(2, int(shape[0] * scale)), max(2, int(shape[1] * scale))), np.uint8)
    cv2.polylines(
        small,
        [np.rint(polyline * scale * 16).astype(np.int32)],
        False,
        255,
        max(1, int(2 * reach * scale)),
        cv2.LINE_AA,
        4,
    )
    small = cv2.GaussianBlur(small, (0, 0), max(0.4, softness * reach * scale))
    return cv2.resize(small, shape[1::-1], interpolation=cv2.INTER_LINEAR).astype(np.float32) * np.float32(1 / 255)


def _to(picture, weight, target):
    picture += weight[..., None] * (target - picture)


def erase(r, picture, ground, outline, width, share):
    """Takes `share` of the outline away, each piece in its own way. Returns the mask of outline points that are
    gone."""
    gone = pieces(r, len(outline), share)
    ways = r.choice(["blur", "fade", "cover", "shadow", "glare", "smear", "haze"], r.integers(1, 4))
    for a, b in _runs(gone):
        run = outline[a:b]
        reach = max(3.0, r.uniform(0.08, 0.3) * width)
        low = np.maximum(0, np.floor(run.min(0) - 3 * reach).astype(int))
        high = np.ceil(run.max(0) + 3 * reach).astype(int) + 1
        here = picture[low[1] : high[1], low[0] : high[0]]
        if min(here.shape[:2]) < 4:
            continue
        behind = ground[low[1] : high[1], low[0] : high[0]]
        weight = _weight(here.shape, run - low, reach, r.uniform(0.25, 0.6))
        WAYS[r.choice(ways)](r, here, behind, weight, run - low, reach)
    return gone


def _blur(r, here, behind, weight, run, reach):
    _to(here, np.minimum(1, 1.6 * weight), soft(here, max(1.2, reach * r.uniform(0.5, 1.0))))


def _fade(r, here, behind, weight, run, reach):
    """The thing goes over into its ground."""
    _to(here, np.minimum(1, 1.3 * weight) * np.float32(r.uniform(0.7, 1)), behind)


def _cover(r, here, behind, weight, run, reach):
    """Something of one tone lies over it: smoke, a blot, a sticker."""
    tone = colour(r) if r.random() < 0.5 else here.reshape(-1, 3).mean(0)
    sharp = np.clip((weight - 0.35) * 8, 0, 1) if r.random() < 0.5 else np.minimum(1, 1.5 * weight)
    _to(here, sharp, np.float32(tone) * (1 + 0.05 * noise(r, here.shape[:2], 12, 2))[..., None])


def _shadow(r, here, behind, weight, run, reach):
    here *= (1 - np.minimum(1, 1.5 * weight) * np.float32(r.uniform(0.75, 0.97)))[..., None]


def _glare(r, here, behind, weight, run, reach):
    here += (np.minimum(1, 1.5 * weight) * np.float32(r.uniform(0.6, 1.1)))[..., None]
    np.minimum(here, 1, out=here)


def _smear(r, here, behind, weight, run, reach):
    """Wiped sideways, as a finger does with chalk."""
    size = int(max(3, reach * 2)) | 1
    kernel = np.zeros((size, size), np.float32)
    angle = r.uniform(0, np.pi)
    end = size / 2 * np.array([np.cos(angle), np.sin(angle)])
    cv2.line(kernel, tuple(np.int32(size / 2 - end)), tuple(np.int32(size / 2 + end)), 1, 1)
    wiped = cv2.filter2D(here, -1, kernel / kernel.sum()) if size < 60 else soft(here, reach)
    _to(here, np.minimum(1, 1.5 * weight), wiped)


def _haze(r, here, behind, weight, run, reach):
    """Contrast goes until little is left."""
    _to(here, np.minimum(1, 1.4 * weight) * np.float32(r.uniform(0.85, 0.98)), here.reshape(-1, 3).mean(0))


WAYS = {
    "blur": _blur,
    "fade": _fade,
    "cover": _cover,
    "shadow": _shadow,
    "glare": _glare,
    "smear": _smear,
    "haze": _haze,
}


def bites(r, picture, ground, mask, outline, width):
    """Round pieces missing from the side. Returns the mask of what they took."""
    taken = np.zeros(mask.shape, np.uint8)
    for _ in range(r.integers(1, 4)):
        centre = outline[r.integers(0, len(outline))] + r.uniform(-0.1, 0.1, 2) * width
        reach = width * r.uniform(0.1, 0.35)
        angle = np.linspace(0, 2 * np.pi, 40)[:-1]
        ragged = reach * (1 + r.uniform(0, 0.2) * wave(r, 39, 8))
        edge = centre + np.stack([np.cos(angle), np.sin(angle)], 1) * ragged[:, None]
        cv2.fillPoly(taken, [np.rint(edge * 16).astype(np.int32)], 255, cv2.LINE_AA, 4)
    _to(picture, taken.astype(np.float32) / 255, ground)
    return taken > 127


CLEAN_SHARE = 0.12  # of the pictures to which a camera adds nothing: no blur and no noise


def camera(r, picture):
    """Blur, vignette, colour cast, noise: what the camera adds. Returns 8-bit and the noise in grey levels."""
    if r.random() < CLEAN_SHARE:
        return np.clip(picture * 255 + 0.5, 0, 255).astype(np.uint8), 0.0
    h, w = picture.shape[:2]
    if r.random() < 0.45:
        picture = cv2.GaussianBlur(picture, (0, 0), r.uniform(0.4, 0.4 + 0.0025 * max(h, w)))
    if r.random() < 0.08:
        size = int(r.uniform(0.006, 0.02) * max(h, w)) | 1
        kernel = np.zeros((size, size), np.float32)
        angle = r.uniform(0, np.pi)
        end = size / 2 * np.array([np.cos(angle), np.sin(angle)])
        cv2.line(kernel, tuple(np.int32(size / 2 - end)), tuple(np.int32(size / 2 + end)), 1, 1)
        picture = cv2.filter2D(picture, -1, kernel / kernel.sum())
    if r.random() < 0.5:
        gain = r.uniform(0.75, 1.15) * near(r, np.float32([0.9, 0.9, 0.9]), 0.1)
        picture = (picture - 0.5) * np.float32(r.uniform(0.6, 1.1)) + 0.5
        picture = picture * gain.astype(np.float32)
    if r.random() < 0.2:
        y, x = np.ogrid[-1 : 1 : h * 1j, -1 : 1 : w * 1j]
        picture = picture * (1 - r.uniform(0.1, 0.5) * (x * x + y * y) / 2).astype(np.float32)[..., None]
    sigma = float(np.exp(r.uniform(0, np.log(26)))) if r.random() < 0.7 else 1.0
    grey = r.standard_normal((h, w), dtype=np.float32) * np.float32(sigma * 0.8)
    if r.random() < 0.3:
        grey = cv2.GaussianBlur(grey, (0, 0), 0.7) * 2
    out = picture * 255 + grey[..., None]
    if sigma > 3:  # colour noise, coarser than the grey noise as after a camera's own denoising
        half = r.standard_normal((h // 2 + 1, w // 2 + 1, 3), dtype=np.float32) * np.float32(
            sigma * r.uniform(0.2, 0.8)
        )
        out += cv2.resize(half, (w, h), interpolation=cv2.INTER_LINEAR)
    return np.clip(out, 0, 255).astype(np.uint8), sigma
