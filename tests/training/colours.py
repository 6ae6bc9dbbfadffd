"""Random colours and textures, BGR in 0..1."""

import cv2
import numpy as np


def colour(r):
    """A colour of things: earth and wood, whites to blacks, or paint."""
    kind = r.random()
    if kind < 0.34:
        hsv = (r.uniform(8, 45), r.uniform(0.15, 0.7), r.uniform(0.15, 0.9))
    elif kind < 0.58:
        hsv = (r.uniform(0, 360), r.uniform(0, 0.15), r.uniform(0.08, 1))
    elif kind < 0.86:
        hsv = (r.uniform(0, 360), r.uniform(0.15, 0.6), r.uniform(0.15, 0.9))
    else:
        hsv = (r.uniform(0, 360), r.uniform(0.6, 0.98), r.uniform(0.3, 1))
    return cv2.cvtColor(np.float32([[hsv]]), cv2.COLOR_HSV2BGR)[0, 0]


def near(r, base, far):
    """A colour `far` (0..1) away from another."""
    return np.clip(base + far * r.uniform(-1, 1, 3), 0, 1).astype(np.float32)


def lab_shift(bgr, lightness, a, b):
    """The colour moved in CIE Lab."""
    lab = cv2.cvtColor(np.float32([[bgr]]), cv2.COLOR_BGR2LAB)
    return np.clip(cv2.cvtColor(lab + np.float32([lightness, a, b]), cv2.COLOR_LAB2BGR), 0, 1)[0, 0]


def noise(r, shape, cells, octaves=3, stretch=(1.0, 1.0)):
    """Smooth noise [h, w], about -1..1: `cells` features across the longer side, finer octaves half as strong."""
    h, w = shape
    total = np.zeros(shape, np.float32)
    strength = 1.0
    for _ in range(octaves):
        rows = max(2, int(round(cells * h / max(h, w) * stretch[1])) + 1)
        columns = max(2, int(round(cells * w / max(h, w) * stretch[0])) + 1)
        if rows > h or columns > w:
            rows, columns = min(rows, h), min(columns, w)
        coarse = r.standard_normal((rows, columns)).astype(np.float32)
        total += strength * cv2.resize(coarse, (w, h), interpolation=cv2.INTER_CUBIC)
        strength *= 0.5
        cells *= 2.2
    return total / 1.6
