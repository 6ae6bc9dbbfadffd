"""A contact sheet of scenes: `sheet.py FOLDER OUT.png [--truth]`, the truth's outline and strokes drawn over."""

import json
import sys
from pathlib import Path

import cv2
import numpy as np

TONES = {
    "careful": (0, 255, 0),
    "sloppy": (0, 160, 255),
    "offcentre": (255, 60, 255),
    "short": (255, 255, 0),
    "over": (255, 0, 0),
}
CELL, COLUMNS = 300, 6


def cell(folder, truth):
    picture = cv2.imread(str(next(folder.glob("image.*"))))
    case = json.loads((folder / "case.json").read_text())
    if truth:
        mask = cv2.imread(str(folder / "mask.png"), cv2.IMREAD_GRAYSCALE)
        for level, tone in ((128, (128, 128, 255)), (255, (0, 0, 255))):
            lines, _ = cv2.findContours((mask == level).astype(np.uint8), cv2.RETR_LIST, cv2.CHAIN_APPROX_NONE)
            cv2.drawContours(picture, lines, -1, tone, max(1, picture.shape[1] // 300))
        for kind, points in case["spines"].items():
            cv2.polylines(
                picture, [np.int32(np.rint(points))], False, TONES.get(kind, (0, 0, 0)), max(1, picture.shape[1] // 300)
            )
    scale = CELL / max(picture.shape[:2])
    small = cv2.resize(picture, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)[:CELL, :CELL]
    out = np.full((CELL, CELL, 3), 60, np.uint8)
    out[: small.shape[0], : small.shape[1]] = small
    return out


def main():
    folders = sorted(p.parent for p in Path(sys.argv[1]).glob("*/case.json"))
    start = int(sys.argv[4]) if len(sys.argv) > 4 else 0
    cells = [cell(f, "--truth" in sys.argv) for f in folders[start : start + 24]]
    while len(cells) % COLUMNS:
        cells.append(np.zeros((CELL, CELL, 3), np.uint8))
    rows = [np.concatenate(cells[i : i + COLUMNS], 1) for i in range(0, len(cells), COLUMNS)]
    cv2.imwrite(sys.argv[2], np.concatenate(rows))


if __name__ == "__main__":
    main()
