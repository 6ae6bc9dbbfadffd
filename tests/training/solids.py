"""A thing in the picture: a middle line with two half widths, its exact mask, and (along, across) coordinates for
every pixel."""

import cv2
import numpy as np

import spines

SUPER = 2  # sub-pixels a side of the mask's raster
ARC = np.linspace(-1, 1, 13)


class Solid:
    """`points` [n, 2] px at equal steps, `left`, `right` [n] half widths px, `bulge` = height over width of its
    ellipses (how far it is seen from above or below; positive bulges towards the end), `ends` as in Profile."""

    def __init__(self, points, left, right, bulge=0.0, ends=("round", "round")):
        self.tangent, normal = spines.frame(points)
        self.normal = normal
        self.half = np.maximum(0.3, (left + right) / 2)
        self.points = points + normal * ((left - right) / 2)[:, None]
        self.bulge, self.ends = bulge, tuple(str(e) for e in ends)
        self.shown = slice(0, len(points))  # the steps inside the picture
        self.length = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()

    def place(self, across):
        """Pixels [n, k, 2] of all steps at `across` in [-1, 1]."""
        t = np.asarray(across)[None, :, None]
        out = self.points[:, None] + self.normal[:, None] * (t * self.half[:, None, None])
        if self.bulge:
            out = out + self.tangent[:, None] * (
                self.bulge * self.half[:, None, None] * np.sqrt(np.maximum(0, 1 - t * t))
            )
        return out

    def side(self, sign):
        """The outline of one side [n, 2]."""
        return self.points + self.normal * (sign * self.half)[:, None]

    def mouth(self, at):
        """The ellipse seen at the start (0) or end (-1) of a turned thing [48, 2]."""
        angle = np.linspace(0, 2 * np.pi, 48)[:, None]
        reach = self.half[at]
        return (
            self.points[at]
            + self.normal[at] * (np.cos(angle) * reach)
            + self.tangent[at] * (np.sin(angle) * reach * self.bulge)
        )

    def coverage(self, size, grow=0.0):
        """Share of every pixel that the thing covers, float32 [h, w]; `size` = (w, h). `grow` px widen it."""
        w, h = size
        canvas = np.zeros((h * SUPER, w * SUPER), np.uint8)
        # A filled polygon includes the sub-pixels its edge runs through: half of one too many on each side.
        half, self.half = self.half, np.maximum(0.05, self.half + grow - 0.5 / SUPER)
        arcs = self.place(ARC if self.bulge else np.array([-1.0, 1.0]))
        mouths = [self.mouth(0), self.mouth(-1)] if self.bulge else []
        self.half = half
        for a, b in zip(arcs[:-1], arcs[1:]):
            _fill(canvas, np.concatenate([a, b[::-1]]))
        for ellipse in mouths:
            _fill(canvas, ellipse)
        canvas = cv2.morphologyEx(canvas, cv2.MORPH_CLOSE, np.ones((3, 3), np.uint8))
        return cv2.resize(canvas, size, interpolation=cv2.INTER_AREA).astype(np.float32) / 255

    def box(self, size, margin=3):
        """The pixels (x0, y0, x1, y1) around it inside the picture."""
        every = self.place(np.array([-1.0, 0.0, 1.0])).reshape(-1, 2)
        reach = self.bulge * self.half.max() if self.bulge else 0
        low = np.floor(every.min(0) - margin - abs(reach)).astype(int)
        high = np.ceil(every.max(0) + margin + 1 + abs(reach)).astype(int)
        return max(0, low[0]), max(0, low[1]), min(size[0], high[0]), min(size[1], high[1])

    def coordinates(self, box):
        """(along in [0, 1], across in [-1, 1]) of the pixels of `box`, float32, NaN-free; later steps lie on top."""
        x0, y0, x1, y1 = box
        w, h = x1 - x0, y1 - y0
        rows = int(np.clip(self.length * 1.3, 60, 4000))
        columns = int(np.clip(self.half.max() * 2 * 1.3, 12, 1400))
        across = np.linspace(-1.12, 1.12, columns)
        coarse = self.place(across[:: max(1, columns // 48)] if columns > 96 else across)
        at = cv2.resize(coarse.astype(np.float32), (columns, rows), interpolation=cv2.INTER_LINEAR)
        along = np.broadcast_to(np.linspace(0, 1, rows, dtype=np.float32)[:, None], (rows, columns))
        t = np.broadcast_to(np.linspace(-1.12, 1.12, columns, dtype=np.float32)[None], (rows, columns))
        column = np.rint(at[..., 0]).astype(np.int32) - x0
        row = np.rint(at[..., 1]).astype(np.int32) - y0
        inside = (column >= 0) & (column < w) & (row >= 0) & (row < h)
        flat = (row * w + column)[inside]
        known = np.zeros(h * w, np.float32)
        maps = np.zeros((h * w, 2), np.float32)
        known[flat] = 1
        maps[flat, 0], maps[flat, 1] = along[inside], t[inside]
        return _filled(maps.reshape(h, w, 2), known.reshape(h, w))

    def cut(self, size):
        """Leaves of `shown` the longest run of the middle line inside the picture; where it is cut the end is open.
        Returns that run's share of the line."""
        inside = ((self.points >= 0) & (self.points <= np.array(size) - 1)).all(1)
        edges = np.flatnonzero(np.diff(np.r_[0, inside.astype(np.int8), 0]))
        if not len(edges):
            return 0.0
        a, b = max(zip(edges[::2], edges[1::2]), key=lambda run: run[1] - run[0])
        self.shown = slice(a, b)
        self.ends = ("cut" if a > 0 else self.ends[0], "cut" if b < len(self.points) else self.ends[1])
        return (b - a) / len(self.points)

    def axis(self):
        """The true middle line with full widths [n, 3], from tip to tip or to the picture's border."""
        first, last = self.shown.start, self.shown.stop - 1
        step = max(1, (last - first) // 240)
        chosen = np.unique(np.r_[np.arange(first, last, step), last])
        return np.concatenate([self.points[chosen], 2 * self.half[chosen, None]], 1)


def _fill(canvas, polygon):
    fine = np.rint(((polygon + 0.5) * SUPER - 0.5) * 16).astype(np.int32)
    cv2.fillPoly(canvas, [fine], 255, shift=4)


def _filled(maps, known):
    """Pixels that no sample hit take the mean of their neighbours that one hit, from near to far."""
    for reach in (3, 5, 11, 31):
        hole = known == 0
        if not hole.any():
            break
        weight = cv2.boxFilter(known, -1, (reach, reach), normalize=False)
        mean = cv2.boxFilter(maps * known[..., None], -1, (reach, reach), normalize=False)
        good = hole & (weight > 0.5)
        maps[good] = mean[good] / weight[good][:, None]
        known[good] = 1
    return maps[..., 0], maps[..., 1]


def room(points, left, right):
    """Whether the sides of a line neither fold in its bends nor touch another stretch of it."""
    step = max(1, len(points) // 90)
    p, half = points[::step], np.maximum(left, right)[::step]
    tangent, _ = spines.frame(p)
    gap = np.linalg.norm(np.diff(p, axis=0), axis=1).mean()
    turn = (
        np.abs(
            np.arctan2(
                tangent[:-1, 0] * tangent[1:, 1] - tangent[:-1, 1] * tangent[1:, 0], (tangent[:-1] * tangent[1:]).sum(1)
            )
        )
        / gap
    )
    if (turn * np.maximum(half[1:], half[:-1]) > 0.85).any():
        return False
    apart = np.abs(np.subtract.outer(np.arange(len(p)), np.arange(len(p)))) * gap
    both = np.add.outer(half, half)
    near = np.linalg.norm(p[:, None] - p[None], axis=2)
    return not ((apart > 1.9 * both) & (near < 1.06 * both)).any()
