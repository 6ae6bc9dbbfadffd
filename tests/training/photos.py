"""The bank of photographs that scenes are made of: which files of which Debian packages, refused or not, and reading
them."""

import argparse
import hashlib
import os
import subprocess
import sys
from pathlib import Path

import cv2
import numpy as np

PACKAGES = {
    "gcompris-qt-data": "photos in .rcc files; CC0, CC BY, CC BY-SA, GPL-3+",
    "python3-skimage": "sample pictures; CC0, public domain",
    "mate-backgrounds": "GPL-2+, CC BY-SA",
    "gnome-backgrounds": "CC BY-SA 3.0",
    "ukui-wallpapers": "CC BY-SA, GPL-3+",
    "lomiri-wallpapers-16.04": "CC BY-SA 3.0",
    "lomiri-wallpapers-20.04": "CC BY-SA 4.0",
    "plasma-workspace-wallpapers": "LGPL-3, CC BY-SA 4.0",
}
LIST = Path(__file__).with_name("photos.tsv")
LONG_SIDE = 1400  # px of a stored photo
SAME_PICTURE = 10  # ORB matches that agree on one affine map from which on two pictures count as the same
VALIDATION_SHARE = 0.2


def bank_folder():
    """Where the unpacked photos lie: not part of the repository."""
    return Path(os.environ.get("SPINELOFT_TRAINING", Path.home() / ".cache/spineloft-training"))


def split_of(sha):
    """A photo belongs to one side for ever: by its hash."""
    return "validation" if int(sha[:8], 16) / 2**32 < VALIDATION_SHARE else "training"


def unpack(packages_folder, work):
    """The packages' trees below `work`, one folder a package."""
    for name in PACKAGES:
        target = work / name
        found = sorted(packages_folder.glob(name + "_*.deb"))
        if target.exists():
            continue
        if not found:
            sys.exit(f"{name}: `apt-get download {name}` into {packages_folder} first")
        target.mkdir(parents=True)
        subprocess.run(["dpkg-deb", "-x", str(found[-1]), str(target)], check=True)


def webp_ranges(data):
    """The WEBP files stored in a Qt resource file."""
    at = data.find(b"RIFF")
    while at >= 0:
        if data[at + 8 : at + 12] == b"WEBP":
            size = int.from_bytes(data[at + 4 : at + 8], "little") + 8
            yield at, data[at : at + size]
        at = data.find(b"RIFF", at + 4)


def candidates(work):
    """(package, name, bytes) of every picture file."""
    for package in PACKAGES:
        for path in sorted((work / package).rglob("*")):
            if not path.is_file() or path.is_symlink():
                continue
            name = str(path.relative_to(work / package))
            if path.suffix == ".rcc":
                for at, data in webp_ranges(path.read_bytes()):
                    yield package, f"{name}@{at}", data
            elif path.suffix.lower() in (".jpg", ".jpeg", ".png", ".webp") and path.stat().st_size > 40_000:
                yield package, name, path.read_bytes()


def looks_like_a_photo(picture):
    """Drawn pictures and icons have large areas of exactly one colour."""
    small = cv2.resize(picture, (256, 256), interpolation=cv2.INTER_NEAREST).astype(np.int16)
    flat = (np.abs(np.diff(small, axis=1)).sum(2)[:-1] <= 1) & (np.abs(np.diff(small, axis=0)).sum(2)[:, :-1] <= 1)
    return flat.mean() < 0.22


class Features:
    """ORB features of one picture, to tell whether another shows the same."""

    orb = cv2.ORB_create(700)
    matcher = cv2.BFMatcher(cv2.NORM_HAMMING)

    def __init__(self, picture):
        grey = cv2.cvtColor(picture, cv2.COLOR_BGR2GRAY)
        scale = 640 / max(grey.shape)
        grey = cv2.resize(grey, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA) if scale < 1 else grey
        self.points, self.words = self.orb.detectAndCompute(grey, None)

    def inliers(self, other):
        if self.words is None or other.words is None or len(self.points) < 8 or len(other.points) < 8:
            return 0
        pairs = [p for p in self.matcher.knnMatch(self.words, other.words, k=2) if len(p) == 2]
        back = {m.queryIdx: m.trainIdx for m in self.matcher.match(other.words, self.words)}
        good = [a for a, b in pairs if a.distance < 0.8 * b.distance and back.get(a.trainIdx) == a.queryIdx]
        if len(good) < SAME_PICTURE:
            return 0
        a = np.float32([self.points[m.queryIdx].pt for m in good])
        b = np.float32([other.points[m.trainIdx].pt for m in good])
        _, inside = cv2.estimateAffine2D(a, b, method=cv2.RANSAC, ransacReprojThreshold=4.0)
        if inside is None:
            return 0
        # One corner found at several scales counts once.
        return len({tuple(np.rint(p / 4).astype(int)) for p in b[inside.ravel() > 0]})


def verdict(picture, sha, reserved, seen, cases):
    """("used" or why it is refused, most ORB inliers with a case and which)."""
    if sha in reserved:
        return "reserved", 0, ""
    if picture is None or picture.ndim != 3 or min(picture.shape[:2]) < 300 or max(picture.shape[:2]) < 480:
        return "small", 0, ""
    if picture.shape[2] != 3 or not looks_like_a_photo(picture):
        return "drawn", 0, ""
    tiny = cv2.resize(cv2.cvtColor(picture, cv2.COLOR_BGR2GRAY), (9, 8), interpolation=cv2.INTER_AREA)
    key = (tiny[:, 1:] > tiny[:, :-1]).ravel()
    if any((key != other).sum() <= 4 for other in seen):
        return "twice", 0, ""
    seen.append(key)
    features = Features(picture)
    most, name = max(((max(c.inliers(features), features.inliers(c)), n) for n, c in cases), default=(0, ""))
    return ("case" if most >= SAME_PICTURE else "used"), most, name


def decoded(data):
    """A picture as it is stored: 8 bits, without an alpha that hides nothing; None where it is no such picture."""
    picture = cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_UNCHANGED)
    if picture is None or picture.dtype != np.uint8:
        return None
    if picture.ndim == 3 and picture.shape[2] == 4 and picture[..., 3].min() == 255:
        return np.ascontiguousarray(picture[..., :3])
    return picture


def make_list(reserved_file, cases_folder):
    """Writes the list from the unpacked packages."""
    reserved = {line.split()[1] for line in reserved_file.read_text().splitlines() if line[0] != "#"}
    paths = sorted(p for p in cases_folder.glob("*/image.*"))
    cases = [(p.parent.name, Features(cv2.imread(str(p)))) for p in paths]
    seen, rows = [], ["sha256\tpackage\tfile\tverdict\tinliers\tcase\tside"]
    for package, name, data in candidates(bank_folder() / "packages"):
        sha = hashlib.sha256(data).hexdigest()
        picture = None if sha in reserved else decoded(data)
        word, most, case = verdict(picture, sha, reserved, seen, cases)
        if word in ("small", "drawn", "twice"):
            continue
        rows.append(f"{sha}\t{package}\t{name}\t{word}\t{most}\t{case}\t{split_of(sha) if word == 'used' else ''}")
    LIST.write_text("\n".join(rows) + "\n")


def fill():
    """Stores the photos of the list in the bank."""
    target = bank_folder() / "photos"
    target.mkdir(parents=True, exist_ok=True)
    wanted = {*names("training"), *names("validation")}
    for _, _, data in candidates(bank_folder() / "packages"):
        name = hashlib.sha256(data).hexdigest()[:16]
        if name not in wanted:
            continue
        picture = decoded(data)
        scale = min(1, LONG_SIDE / max(picture.shape[:2]))
        small = cv2.resize(picture, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA) if scale < 1 else picture
        cv2.imwrite(str(target / f"{name}.jpg"), small, [cv2.IMWRITE_JPEG_QUALITY, 92])
        wanted.remove(name)
    if wanted:
        sys.exit(f"{len(wanted)} photos of {LIST} are in other versions of the packages, or another list is needed")


_lists = {}


def names(side):
    """The photos of one side, in the list's order: the first 16 digits of their hashes."""
    if side not in _lists:
        rows = [line.split("\t") for line in LIST.read_text().splitlines()[1:]]
        _lists[side] = [r[0][:16] for r in rows if r[3] == "used" and r[6] == side]
    return _lists[side]


def read(name):
    """One photo, BGR uint8."""
    picture = cv2.imread(str(bank_folder() / "photos" / f"{name}.jpg"))
    if picture is None:
        sys.exit(f"photo {name} is missing: run photos.py (see README.md)")
    return picture


if __name__ == "__main__":
    say = argparse.ArgumentParser(description=__doc__)
    say.add_argument("--packages", type=Path, required=True, help="folder with the downloaded .deb files")
    say.add_argument("--reserved", type=Path, help="with --cases: makes the list anew, without these files")
    say.add_argument("--cases", type=Path, help="folder of cases no photo may share a picture with")
    given = say.parse_args()
    if (given.reserved is None) != (given.cases is None):
        say.error("--reserved and --cases are given together: the list is made anew with both")
    unpack(given.packages, bank_folder() / "packages")
    if given.reserved:
        make_list(given.reserved, given.cases)
    fill()
