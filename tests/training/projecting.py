"""From a mesh to a case: where its points fall in the picture, its exact mask, and the middle line of a mask."""

import cv2
import numpy as np

import spines
from grounds import soft

SUPER = 4


class Camera:
    """A pin-hole camera: `place` [3], `facing` [3, 3] (columns right, up, backwards), `focal` px, `centre` px = what
    of the view lies in the picture's middle (up positive), `size` (w, h)."""

    def __init__(self, place, facing, focal, centre, size):
        self.place, self.facing, self.focal, self.centre, self.size = place, facing, focal, centre, size

    def project(self, points):
        """Pixels [n, 2], pixel centres at integers."""
        flat = (np.asarray(points) - self.place) @ self.facing
        seen = flat[:, :2] / np.maximum(1e-6, -flat[:, 2:]) * self.focal - self.centre
        return np.stack([self.size[0] / 2 + seen[:, 0], self.size[1] / 2 - seen[:, 1]], 1) - 0.5

    def cover(self, points, faces):
        """The share of every pixel that the mesh covers, float32 [h, w]."""
        w, h = self.size
        canvas = np.zeros((h * SUPER, w * SUPER), np.uint8)
        near = (np.asarray(points) - self.place) @ self.facing[:, 2] > -0.05  # beside or behind the camera
        at = np.clip(((self.project(points) + 0.5) * SUPER - 0.5) * 16, -1e6, 1e6).astype(np.int32)
        for face in faces:
            if not near[face].any():
                cv2.fillPoly(canvas, [at[face]], 255, shift=4)
        return cv2.resize(canvas, self.size, interpolation=cv2.INTER_AREA).astype(np.float32) / 255


class Measured:
    """The middle line of a mask with its widths, in the place of a Solid."""

    def __init__(self, axis):
        self.points, self.half = axis[:, :2], axis[:, 2] / 2
        self.tangent, self.normal = spines.frame(self.points)
        self.shown, self.ends = slice(0, len(axis)), ("flat", "flat")
        self.length = float(np.linalg.norm(np.diff(self.points, axis=0), axis=1).sum())
        self._axis = axis

    def side(self, sign):
        return self.points + self.normal * (sign * self.half)[:, None]

    def axis(self):
        return self._axis


def measured(cover, guide):
    """The middle line with widths [n, 3] of a mask about a smooth guide line [n, 2] through it, or None where the
    guide does not lead through most of the mask: the middle of the run across the guide, smoothed over a tenth of
    the length."""
    h, w = cover.shape
    line = spines.resampled(guide, 160)
    inside = ((line > 1) & (line < [w - 2, h - 2])).all(1)
    at = np.rint(np.clip(line, 0, [w - 1, h - 1])).astype(int)
    inside &= cover[at[:, 1], at[:, 0]] >= 0.5
    if inside.mean() < 0.7:
        return None
    line = spines.resampled(line[np.flatnonzero(inside)[0] : np.flatnonzero(inside)[-1] + 1], 160)
    _, normal = spines.frame(line)
    left, right = (_run(cover, line, sign * normal) for sign in (-1, 1))
    offset = (right - left) / 2
    trusted = np.arange(160)[8:-8]  # beyond, runs end in a corner of the end as often as in a side
    offset = np.interp(np.arange(160), trusted, offset[trusted])
    kernel = np.exp(-0.5 * (np.arange(-36, 37) / 12.0) ** 2)
    line = line + normal * np.convolve(np.pad(offset, 36, mode="edge"), kernel / kernel.sum(), "valid")[:, None]
    _, normal = spines.frame(line)
    left, right = (_run(cover, line, sign * normal) for sign in (-1, 1))
    return np.concatenate([line, np.maximum(0.5, left + right)[:, None]], 1)


def _run(cover, line, way):
    """How far each point of a line lies inside, going `way`, px."""
    steps = np.arange(0, 0.7 * max(cover.shape), 0.5, dtype=np.float32)
    x = (line[:, :1] + way[:, :1] * steps).astype(np.float32)
    y = (line[:, 1:] + way[:, 1:] * steps).astype(np.float32)
    inside = cv2.remap(cover, x, y, cv2.INTER_LINEAR, borderMode=cv2.BORDER_CONSTANT, borderValue=0) >= 0.5
    return np.where(inside.all(1), steps[-1], np.maximum(0, steps[np.argmin(inside, 1)] - 0.25))


def without(picture, cover):
    """The picture with the covered pixels filled from around them."""
    keep = (1 - cv2.dilate(cover, np.ones((5, 5))))[..., None]
    far = 0.06 * max(picture.shape)
    weight = soft(np.repeat(keep, 3, 2), far)
    return picture * keep + (1 - keep) * soft(picture * keep, far) / np.maximum(weight, 1e-3)
