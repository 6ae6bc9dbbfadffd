"""The bank of cut-out photographs of things (tuxpaint-stamps-default, GPL-2): which are one long piece, and reading
them."""

import argparse
import hashlib
import sys
from pathlib import Path

import cv2
import numpy as np

from photos import SAME_PICTURE, Features, bank_folder, split_of
from projecting import Measured, measured

LIST = Path(__file__).with_name("stamps.tsv")
SMALLEST = 200  # px of the long side


def upright(alpha):
    """The angle (degrees) that turns the thing's long axis upright, and its raster turned so."""
    y, x = np.nonzero(alpha > 127)
    centred = np.stack([x - x.mean(), y - y.mean()], 1)
    _, _, ways = np.linalg.svd(centred[:: max(1, len(x) // 4000)], full_matrices=False)
    angle = float(np.degrees(np.arctan2(ways[0, 1], ways[0, 0]))) - 90
    size = int(np.hypot(*alpha.shape)) + 2
    turn = cv2.getRotationMatrix2D((float(x.mean()), float(y.mean())), angle, 1.0)
    turn[:, 2] += size / 2 - np.array([x.mean(), y.mean()])
    return angle, cv2.warpAffine(alpha, turn, (size, size)) > 127


def one_long_piece(alpha):
    """Whether nearly every slice across the long axis is one run, and the thing longer than wide."""
    _, turned = upright(alpha)
    rows = turned[turned.any(1)]
    runs = (np.diff(np.pad(rows, ((0, 0), (1, 1))).astype(np.int8), axis=1) == 1).sum(1)
    return len(rows) > 1.25 * rows.sum(1).max() and (runs == 1).mean() > 0.93


def make_list(package_folder, cases_folder):
    """Writes the list."""
    cases = [(p.parent.name, Features(cv2.imread(str(p)))) for p in sorted(cases_folder.glob("*/image.*"))]
    rows = ["sha256\tfile\tinliers\tverdict\tside"]
    for path in sorted(package_folder.rglob("*.png")):
        picture = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
        if picture is None or picture.dtype != np.uint8 or picture.ndim != 3 or picture.shape[2] != 4:
            continue
        alpha = picture[..., 3]
        box = cv2.boundingRect((alpha > 127).astype(np.uint8))
        if max(box[2:]) < SMALLEST or alpha.min() > 127 or not _photographed(picture):
            continue
        sha = hashlib.sha256(path.read_bytes()).hexdigest()
        features = Features(np.ascontiguousarray(picture[..., :3]))
        most = max(max(c.inliers(features), features.inliers(c)) for _, c in cases)
        word = "case" if most >= SAME_PICTURE else "long" if one_long_piece(alpha) else "clutter"
        rows.append(f"{sha}\t{path.relative_to(package_folder)}\t{most}\t{word}\t{split_of(sha)}")
    LIST.write_text("\n".join(rows) + "\n")


def fill(package_folder):
    """Stores the stamps of the list in the bank."""
    target = bank_folder() / "stamps"
    target.mkdir(parents=True, exist_ok=True)
    for sha, file, _, word, _ in (line.split("\t") for line in LIST.read_text().splitlines()[1:]):
        if word != "case":
            (target / f"{sha[:16]}.png").write_bytes((package_folder / file).read_bytes())


def _photographed(picture):
    """Whether neighbours well inside the thing seldom have exactly one colour, as in drawn stamps."""
    inside = cv2.erode((picture[..., 3] > 250).astype(np.uint8), np.ones((9, 9), np.uint8))[:, 1:] > 0
    same = (np.abs(np.diff(picture[..., :3].astype(np.int16), axis=1)).sum(2) <= 1)[inside]
    return same.size > 2000 and same.mean() < 0.3


def names(side, word):
    """The stamps of one side and kind ("long" or "clutter")."""
    rows = [line.split("\t") for line in LIST.read_text().splitlines()[1:]]
    return [r[0][:16] for r in rows if r[3] == word and r[4] == side]


def read(name):
    """One stamp, BGRA uint8."""
    picture = cv2.imread(str(bank_folder() / "stamps" / f"{name}.png"), cv2.IMREAD_UNCHANGED)
    if picture is None:
        sys.exit(f"stamp {name} is missing: run stamps.py (see README.md)")
    return picture


def warped(r, name, size, fill, bend=0.0):
    """A stamp turned, mirrored, sheared and bent, `fill` of the picture large: (BGR float [h, w, 3], cover [h, w],
    and the ends of its long axis [60, 2])."""
    stamp = read(name)
    stamp = stamp[:, ::-1] if r.random() < 0.5 else stamp
    alpha = stamp[..., 3]
    angle, _ = upright(alpha)
    y, x = np.nonzero(alpha > 127)
    middle = np.array([x.mean(), y.mean()])
    way = np.array([np.sin(np.radians(-angle)), np.cos(np.radians(-angle))])
    reach = (np.stack([x, y], 1) - middle) @ way
    turn = r.uniform(0, 360) if r.random() < 0.5 else angle + r.normal(0, 10)
    linear = cv2.getRotationMatrix2D((0, 0), turn, 1.0)[:, :2] @ np.array(
        [[1, r.uniform(-0.1, 0.1)], [0, r.uniform(0.8, 1.2)]]
    )
    corners = np.stack([x, y], 1)[:: max(1, len(x) // 3000)] @ linear.T
    low, high = corners.min(0), corners.max(0)
    w, h = size
    scale = fill * min(w / (high[0] - low[0]), h / (high[1] - low[1]))
    linear, low, high = linear * scale, low * scale, high * scale
    shift = r.uniform(0.1, 0.9, 2) * (np.array(size) - (high - low)) - low
    # From picture to stamp; the bend moves rows of the picture sideways.
    column, row = np.meshgrid(np.arange(w, dtype=np.float32), np.arange(h, dtype=np.float32))
    away = bend * (np.sin(np.pi * (row - shift[1] - low[1]) / max(1.0, high[1] - low[1])) - 0.5) * (high[0] - low[0])
    back = np.linalg.inv(linear).astype(np.float32)
    u, v = column - away.astype(np.float32) - np.float32(shift[0]), row - np.float32(shift[1])
    at = back[0, 0] * u + back[0, 1] * v, back[1, 0] * u + back[1, 1] * v
    soft = stamp.astype(np.float32) / 255
    soft[..., :3] *= soft[..., 3:]
    seen = cv2.remap(
        cv2.GaussianBlur(soft, (0, 0), max(0.01, 0.4 / scale)) if scale < 0.7 else soft,
        *at,
        cv2.INTER_LINEAR,
        borderMode=cv2.BORDER_CONSTANT,
        borderValue=(0, 0, 0, 0),
    )
    cover = seen[..., 3]
    axis = (middle + way * np.linspace(reach.min(), reach.max(), 60)[:, None]) @ linear.T + shift
    axis[:, 0] += (
        bend
        * (np.sin(np.pi * (axis[:, 1] - shift[1] - low[1]) / max(1.0, high[1] - low[1])) - 0.5)
        * (high[0] - low[0])
    )
    tone = (r.uniform(0.6, 1.2) * r.uniform(0.85, 1.15, 3)).astype(np.float32)
    return np.clip(seen[..., :3] * tone, 0, 1), cover, axis


def lay(picture, seen, cover):
    """Puts a warped stamp, premultiplied, over the picture in place."""
    picture *= 1 - cover[..., None]
    picture += np.minimum(seen, cover[..., None])


def thing(r, picture, size, side):
    """Lays a long stamp: (cover, middle line as Measured, name), or None where its line leaves it."""
    name = str(r.choice(names(side, "long")))
    seen, cover, axis = warped(
        r, name, size, 0.97 - 0.4 * r.random() ** 1.6, r.uniform(-0.35, 0.35) if r.random() < 0.4 else 0.0
    )
    line = measured(cover, axis)
    if line is None:
        return None
    lay(picture, seen, cover)
    return cover, Measured(line), name


if __name__ == "__main__":
    say = argparse.ArgumentParser(description=__doc__)
    say.add_argument("--package", type=Path, required=True, help="the unpacked tuxpaint-stamps-default")
    say.add_argument("--cases", type=Path, help="makes the list anew, without what shares a picture with these cases")
    given = say.parse_args()
    if given.cases:
        make_list(given.package, given.cases)
    fill(given.package)
