"""Writes scenes as cases: `make_scenes.py --seeds 0:400 --out DIR [--jobs N]`."""

import argparse
import json
import time
from multiprocessing import Pool
from pathlib import Path

import cv2
import numpy as np

import scene as scenes


def faint_share(picture, outline):
    """% of the outline with no Canny edge within 3 px."""
    edges = cv2.Canny(cv2.GaussianBlur(cv2.cvtColor(picture, cv2.COLOR_BGR2GRAY), (0, 0), 1.2), *scenes.NO_EDGE)
    near = cv2.dilate(edges, np.ones((7, 7), np.uint8))
    h, w = near.shape
    at = np.rint(outline).astype(int)
    inside = (at[:, 0] >= 0) & (at[:, 0] < w) & (at[:, 1] >= 0) & (at[:, 1] < h)
    at = at[inside]
    return (100.0 * float((near[at[:, 1], at[:, 0]] == 0).mean()) if len(at) else 0.0), edges


def case_of(scene):
    """case.json of a scene, in the format of the benchmark's cases."""
    said = scene.said
    h, w = scene.mask.shape
    faint, edges = faint_share(scene.picture, scenes.outline_of(scene.solid))
    part = int((scene.mask == 255).sum())
    rounded = lambda points: [[round(float(v), 2) for v in p] for p in points]  # noqa: E731
    name = f"{scene.seed:06d}"
    return {
        "id": name,
        "title": f"{said['profile']} along {said['spine']}, {said['look']}",
        "category": said["category"],
        "subject": said["profile"],
        "part": "whole object",
        "source": {"name": "tests/training", "url": ""},
        "image": "image.jpg",
        "width": w,
        "height": h,
        "mask": "mask.png",
        **({"mask_visible": "mask_visible.png"} if scene.visible is not None else {}),
        "boundary_tolerance_px": round(float(said.get("tolerance", 1.0)), 2),
        "ends": {k: "open" if e in ("open", "cut") else "closed" for k, e in zip(("start", "end"), scene.solid.ends)},
        "difficulty": {
            "occlusion_pct": round(said.get("occlusion", 0.0), 1),
            "missing_boundary_pct": round(said["missing"], 1),
            "noise_sigma": round(said["noise"], 1),
            "no_edge_pct": round(faint, 1),
            "inner_edges_per_1000px": round(
                1000.0 * float(((edges > 0) & (scene.mask == 255)).sum()) / max(1, part), 1
            ),
            "tags": said["tags"],
        },
        "scene": {
            "version": scenes.VERSION,
            "seed": scene.seed,
            "split": said["side"],
            "kind": said["category"],
            "spine": said["spine"],
            "profile": said["profile"],
            "look": said["look"],
            "object": f"{said['spine']}/{said['profile']}/{said['look']}",
            "background": said["background"],
        },
        "spines": {k: rounded(v) for k, v in scene.strokes.items()},
        "axis": rounded(scene.solid.axis()),
        "coordinates": "pixels, x right, y down, pixel centres at integers",
    }


def write(scene, folder):
    folder.mkdir(parents=True, exist_ok=True)
    cv2.imwrite(str(folder / "image.jpg"), scene.picture, [cv2.IMWRITE_JPEG_QUALITY, scene.said["quality"]])
    cv2.imwrite(str(folder / "mask.png"), scene.mask, [cv2.IMWRITE_PNG_COMPRESSION, 1])
    if scene.visible is not None:
        cv2.imwrite(str(folder / "mask_visible.png"), scene.visible, [cv2.IMWRITE_PNG_COMPRESSION, 1])
    (folder / "case.json").write_text(json.dumps(case_of(scene), separators=(",", ":")))


def one(job):
    seed, out = job
    write(scenes.make(seed), out / f"{seed:06d}")


def main():
    say = argparse.ArgumentParser(description=__doc__)
    say.add_argument("--seeds", required=True, help="FIRST:END, END not included; from 10000 on they are for training")
    say.add_argument("--out", type=Path, required=True)
    say.add_argument("--jobs", type=int, default=1)
    given = say.parse_args()
    first, end = map(int, given.seeds.split(":"))
    jobs = [(seed, given.out) for seed in range(first, end)]
    start = time.process_time()
    if given.jobs == 1:
        for job in jobs:
            one(job)
        print(f"{len(jobs)} scenes, {(time.process_time() - start) / max(1, len(jobs)):.3f} CPU s each")
    else:
        with Pool(given.jobs) as pool:
            for _ in pool.imap_unordered(one, jobs, chunksize=8):
                pass


if __name__ == "__main__":
    main()
