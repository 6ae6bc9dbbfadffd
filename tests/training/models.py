"""The bank of furniture models for renders: which of sweethome3d-furniture are one upright or long piece, and which
are refused."""

import argparse
import hashlib
import os
import sys
import zipfile
from pathlib import Path

import cv2
import numpy as np

from photos import bank_folder, split_of

LIST = Path(__file__).with_name("models.tsv")
# Models of benchmark cases and their near variants.
REFUSED = ("mug", "beer_bottle", "faucet", "vase-lamp", "vaselamp", "coconut", "vase3", "palm")
RASTER = 160


def _geometry(text):
    """Vertices [n, 3] and faces (lists of indices) of an OBJ."""
    points, faces = [], []
    for line in text.splitlines():
        if line.startswith("v "):
            points.append([float(v) for v in line.split()[1:4]])
        elif line.startswith("f "):
            faces.append([int(v.split("/")[0]) for v in line.split()[1:]])
    return np.array(points, np.float64), [[i - 1 if i > 0 else i for i in f] for f in faces]


def _view(points, faces, along, across):
    """The silhouette, the axis `along` upwards, as a raster of 0 and 1."""
    flat = points[:, [across, along]]
    low, size = flat.min(0), np.ptp(flat, axis=0).max()
    at = ((flat - low) / max(size, 1e-9) * (RASTER - 1) * 16).astype(np.int32)
    canvas = np.zeros((RASTER, RASTER), np.uint8)
    for face in faces:
        cv2.fillPoly(canvas, [at[face]], 1, shift=4)
    rows = np.flatnonzero(canvas.any(1))
    return canvas[rows[0] : rows[-1] + 1]


def _one_piece(view):
    """Whether nearly every row is one run, about a line that hardly wanders, and the whole no mere box."""
    padded = np.pad(view, ((0, 0), (1, 1))).astype(np.int8)
    runs = (np.diff(padded, axis=1) == 1).sum(1)
    width = view.sum(1)
    filled = view.sum() / (len(view) * max(1, width.max()))
    return (runs == 1).mean() > 0.95 and len(view) > 0.9 * width.max() and filled < 0.93


def axis_of(points, faces):
    """0, 1 or 2: along which axis the model is one long piece; None if along none."""
    extent = np.ptp(points, axis=0)
    for along in dict.fromkeys((1, int(extent.argmax()))):
        if all(_one_piece(_view(points, faces, along, a)) for a in range(3) if a != along):
            return along
    return None


def _counts(data):
    """How many vertices and faces: two models with the same numbers are taken for one model."""
    points, faces = _geometry(data.decode("latin1"))
    return len(points), len(faces)


def _reserved_counts(package_folder, reserved):
    """The counts of all reserved models."""
    found = set()
    for archive in package_folder.rglob("*.sh3f"):
        with zipfile.ZipFile(archive) as content:
            for name in (n for n in content.namelist() if n.endswith(".obj")):
                data = content.read(name)
                if hashlib.sha256(data).hexdigest() in reserved:
                    found.add(_counts(data))
    return found


def build(package_folder, reserved_file):
    """Unpacks the models that can be used and writes the list."""
    reserved = {line.split()[1] for line in reserved_file.read_text().splitlines() if line[0] != "#"}
    twins = _reserved_counts(package_folder, reserved)
    rows = ["sha256\tarchive\tfile\tverdict\taxis\tside"]
    for archive in sorted(package_folder.rglob("*.sh3f")):
        with zipfile.ZipFile(archive) as content:
            for name in sorted(n for n in content.namelist() if n.endswith(".obj")):
                data = content.read(name)
                sha = hashlib.sha256(data).hexdigest()
                word, along = "used", None
                if sha in reserved:
                    word = "reserved"
                elif any(part in name for part in REFUSED):
                    word = "case"
                elif _counts(data) in twins:
                    word = "twin"
                elif len(data) > 5_000_000:
                    word = "large"
                else:
                    points, faces = _geometry(data.decode("latin1"))
                    along = axis_of(points, faces) if len(faces) > 40 else None
                    word = "clutter" if along is None else "used"
                if word in ("used", "clutter"):
                    folder = os.path.dirname(name)
                    for part in content.namelist():
                        if part.startswith(folder + "/"):
                            content.extract(part, bank_folder() / "models" / archive.stem)
                side = split_of(sha) if word in ("used", "clutter") else ""
                rows.append(f"{sha}\t{archive.stem}\t{name}\t{word}\t{'' if along is None else along}\t{side}")
    LIST.write_text("\n".join(rows) + "\n")


def names(side, word="used"):
    """(path, axis) of the models of one side."""
    out = []
    for line in LIST.read_text().splitlines()[1:]:
        _, archive, name, verdict, along, where = line.split("\t")
        if verdict == word and where == side:
            out.append((str(bank_folder() / "models" / archive / name), int(along) if along else 1))
    return out


if __name__ == "__main__":
    say = argparse.ArgumentParser(description=__doc__)
    say.add_argument("--package", type=Path, required=True, help="the unpacked sweethome3d-furniture")
    say.add_argument("--reserved", type=Path, required=True)
    given = say.parse_args()
    sys.exit(build(given.package, given.reserved))
