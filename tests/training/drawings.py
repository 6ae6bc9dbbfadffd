"""Drawings of a thing: lines by hand, ink, hatching, flat colour."""

import cv2
import numpy as np

from colours import colour, near, noise
from damage import pieces
from spines import resampled, wave


class Pen:
    """One pen: its colour, thickness and how unsteady it is."""

    def __init__(self, r, paper):
        self.r = r
        longest = max(paper.shape[:2])
        kind = r.random()
        self.thick = longest * (r.uniform(0.002, 0.006) if kind < 0.6 else r.uniform(0.006, 0.018))
        self.tone = near(r, np.float32([0.1, 0.1, 0.1]), 0.1) if r.random() < 0.75 else colour(r) * 0.7
        ground = paper.reshape(-1, 3).mean(0)
        if abs(float((self.tone - ground).mean())) < 0.25:  # chalk on dark paper
            self.tone = near(r, np.float32([0.95] * 3 if ground.mean() < 0.5 else [0.08] * 3), 0.05)
        self.wobble = longest * r.choice([0.0, 0.0008, 0.002, 0.005]) * r.uniform(0.5, 1.2)
        self.pressure = r.choice([0.0, 0.3, 0.6])
        self.repeats = int(r.choice([1, 1, 1, 2, 3]))
        self.faint = r.uniform(0.35, 1.0) if r.random() < 0.3 else 1.0

    def line(self, ink, points, thick=1.0, gone=None):
        """Draws a polyline into `ink` [h, w] uint8 (255 = full); points marked in `gone` are left out."""
        r = self.r
        for again in range(self.repeats):
            n = max(8, min(len(points), 400))
            path = resampled(points, n)
            far = self.wobble * (1 + again)
            if far:
                length = np.linalg.norm(np.diff(path, axis=0), axis=1).sum()
                bumps = np.clip(length / (25 * far + 20), 3, 40)
                path = path + far * np.stack([wave(r, n, bumps), wave(r, n, bumps)], 1)
            hidden = np.zeros(n, bool) if gone is None else gone[np.linspace(0, len(gone) - 1, n).astype(int)]
            press = 1 + self.pressure * wave(r, n, 6)
            self._runs(ink, path, hidden, press, thick)

    def _runs(self, ink, path, hidden, press, thick):
        edges = np.flatnonzero(np.diff(np.r_[0, (~hidden).astype(np.int8), 0]))
        for a, b in zip(edges[::2], edges[1::2]):
            step = 6 if self.pressure else b - a
            for i in range(a, b - 1, step):
                piece = np.rint(path[i : min(b, i + step + 1)] * 16).astype(np.int32)
                width = max(1, int(round(self.thick * thick * press[i] * (0.85 if self.repeats > 1 else 1))))
                cv2.polylines(ink, [piece], False, 255, width, cv2.LINE_AA, 4)


def _arc(solid, i, sign=1):
    """A line across at step i, bowed as on something round."""
    t = np.linspace(-1, 1, 21)[:, None]
    bow = sign * (abs(solid.bulge) + 0.1) * solid.half[i] * np.sqrt(1 - t * t)
    return solid.points[i] + solid.normal[i] * (t * solid.half[i]) + solid.tangent[i] * bow


def outline(r, pen, ink, solid, gone_share):
    """Both sides and the ends, with gaps. Returns the share of the outline left out."""
    n = len(solid.points)
    left_out = []
    shift = r.uniform(0, 0.02) * solid.half.max() if r.random() < 0.3 else 0
    for sign in (-1, 1):
        gone = pieces(r, n, gone_share) if gone_share else np.zeros(n, bool)
        left_out.append(gone.mean())
        path = solid.side(sign)
        over = int(r.integers(0, 4))  # lines that overshoot or stop before the corner
        pen.line(ink, path[over : n - int(r.integers(0, 4))] + r.uniform(-shift, shift, 2), gone=gone)
        if r.random() < 0.12:  # a second outline a little inside
            pen.line(ink, path - sign * solid.normal * (r.uniform(0.04, 0.12) * solid.half)[:, None], 0.6)
    for at, way in ((0, -1), (-1, 1)):
        end = solid.ends[0 if at == 0 else 1]
        if end in ("open", "cut") or r.random() < 0.06:
            continue
        if solid.bulge:
            ellipse = solid.mouth(at)
            pen.line(ink, np.concatenate([ellipse, ellipse[:1]]))
        else:
            pen.line(ink, np.stack([solid.side(-1)[at], solid.side(1)[at]]))
    return float(np.mean(left_out))


def hatching(r, pen, ink, solid, inside):
    """Strokes that shade: across, slanted or crossed, on one side or all over; cut at the outline or not."""
    layer = np.zeros_like(ink)
    h, w = ink.shape
    low, high = solid.place([-1.0, 1.0]).reshape(-1, 2).min(0), solid.place([-1.0, 1.0]).reshape(-1, 2).max(0)
    gap = max(3.0, r.uniform(0.06, 0.3) * solid.half.max())
    thick = max(1, int(pen.thick * r.uniform(0.3, 0.8)))
    lit = r.uniform(-0.4, 0.5)
    side = r.choice([-1, 1])
    if r.random() < 0.5:  # follows the form
        for i in range(0, len(solid.points), max(1, int(gap / max(1e-6, solid.length) * len(solid.points)))):
            arc = _arc(solid, i, 1) if side > 0 else _arc(solid, i, 1)[::-1]
            start = int(np.clip((lit + 1) / 2 * 21 + r.normal(0, 2), 0, 18))
            cv2.polylines(layer, [np.rint(arc[start:] * 16).astype(np.int32)], False, 255, thick, cv2.LINE_AA, 4)
    else:
        for angle in r.uniform(0, np.pi, r.choice([1, 1, 2])):
            way = np.array([np.cos(angle), np.sin(angle)])
            across = np.array([-way[1], way[0]])
            centre, reach = (low + high) / 2, np.linalg.norm(high - low) / 2
            for d in np.arange(-reach, reach, gap):
                a = centre + across * d + r.uniform(-1, 1, 2) * gap * 0.2
                ends = np.stack([a - way * reach, a + way * reach])
                cv2.polylines(layer, [np.rint(ends * 16).astype(np.int32)], False, 255, thick, cv2.LINE_AA, 4)
        half = np.zeros_like(ink)
        edge = solid.side(side)
        middle = solid.points + solid.normal * (lit * side * solid.half)[:, None]
        cv2.fillPoly(half, [np.rint(np.concatenate([edge, middle[::-1]]) * 16).astype(np.int32)], 255, cv2.LINE_AA, 4)
        if r.random() < 0.75:
            layer = cv2.min(layer, half)
        else:
            layer = (layer * inside).astype(np.uint8)
    return cv2.max(ink, layer)


def details(r, pen, ink, solid):
    """Lines inside: rings, a middle line, spots, a window for a label, stripes along, an eye."""
    n = len(solid.points)
    for _ in range(r.integers(0, 7)):
        kind = r.random()
        i = int(r.integers(n // 20, n - n // 20))
        if kind < 0.4:
            pen.line(ink, _arc(solid, i, r.choice([-1, 1])), r.uniform(0.5, 1))
        elif kind < 0.65:
            place = r.uniform(-0.8, 0.8)
            a, b = sorted(r.integers(0, n, 2))
            if b - a > 8:
                pen.line(ink, (solid.points + solid.normal * (place * solid.half)[:, None])[a:b], r.uniform(0.4, 1))
        elif kind < 0.8:
            a, b = sorted(r.integers(0, n, 2))
            if b - a > 8:
                box = [
                    solid.points[k] + solid.normal[k] * (s * 0.7 * solid.half[k])
                    for k, s in ((a, -1), (b, -1), (b, 1), (a, 1), (a, -1))
                ]
                pen.line(ink, np.array(box), 0.8)
        else:
            angle = np.linspace(0, 2 * np.pi, 24)[:, None]
            at = solid.points[i] + solid.normal[i] * r.uniform(-0.5, 0.5) * solid.half[i]
            pen.line(
                ink, at + solid.half[i] * r.uniform(0.05, 0.3) * np.concatenate([np.cos(angle), np.sin(angle)], 1), 0.8
            )


def fill(r, picture, solid, inside):
    """Flat colour, seldom exactly inside the lines, with bands of shade."""
    tone = colour(r)
    area = inside
    if r.random() < 0.4:
        move = np.float32([[1, 0, r.normal(0, 0.08) * solid.half.max()], [0, 1, r.normal(0, 0.08) * solid.half.max()]])
        area = cv2.warpAffine(inside, move, inside.shape[::-1])
    strength = r.uniform(0.3, 1)
    if r.random() < 0.3:  # crayon
        strength = np.clip(strength * (0.8 + 0.5 * noise(r, inside.shape, 150, 2, (1.0, 0.2))), 0, 1)
    picture += (area * strength)[..., None] * (tone - picture)
    for _ in range(r.integers(0, 3)):
        side, start, end = r.choice([-1, 1]), r.uniform(-0.6, 0.6), 1.0
        a = solid.points + solid.normal * (side * start * solid.half)[:, None]
        b = solid.points + solid.normal * (side * end * solid.half)[:, None]
        layer = np.zeros(inside.shape, np.uint8)
        cv2.fillPoly(layer, [np.rint(np.concatenate([a, b[::-1]]) * 16).astype(np.int32)], 255, cv2.LINE_AA, 4)
        picture += (layer / np.float32(255) * area * r.uniform(0.3, 1))[..., None] * (near(r, tone, 0.35) - picture)


def ink_on(r, picture, ink, pen):
    """Lays the ink on the paper: solid, or broken by the paper's grain like pencil and chalk."""
    amount = ink.astype(np.float32) * np.float32(pen.faint / 255)
    if r.random() < 0.3:
        amount *= np.clip(0.75 + 0.5 * noise(r, ink.shape, 250, 2), 0, 1)
    picture += amount[..., None] * (np.float32(pen.tone) - picture)
