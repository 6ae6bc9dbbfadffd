"""Laws of the scenes, run by hand: `python3 -m unittest -v` in this folder (needs the bank of photos, see
README.md)."""

import json
import tempfile
import unittest
from pathlib import Path

import cv2
import numpy as np

import families
import grounds
import looks
import make_scenes
import meshes
import models
import photos
import profiles
import projecting
import scene as scenes
import spines
import stamps
import strokes
from solids import Solid

SEEDS = (*range(12), *range(10_000, 10_024))


class Laws(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scenes = {seed: scenes.make(seed) for seed in SEEDS}

    def test_a_seed_gives_the_same_bytes(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a", "b"):
                for seed in SEEDS[::6]:
                    make_scenes.write(scenes.make(seed), Path(folder) / name / str(seed))
            files = sorted(p.relative_to(Path(folder) / "a") for p in Path(folder, "a").rglob("*") if p.is_file())
            self.assertTrue(files)
            for file in files:
                self.assertEqual(Path(folder, "a", file).read_bytes(), Path(folder, "b", file).read_bytes(), file)

    def test_every_scene_shows_its_part(self):
        for seed, scene in self.scenes.items():
            self.assertGreater((scene.mask == 255).sum(), 60, seed)
            self.assertEqual(scene.mask.shape, scene.picture.shape[:2])
            if scene.visible is not None:
                self.assertFalse(((scene.visible == 255) & (scene.mask != 255)).any(), seed)

    def test_strokes_keep_their_distance(self):
        # The middle of a stroke, in widths from the axis; a thin thing's own raster is a pixel.
        most = {"careful": 0.06, "sloppy": 0.2, "offcentre": 0.42, "short": 0.2, "over": 0.06}
        for seed, scene in self.scenes.items():
            axis = scene.solid.axis()
            for kind, stroke in scene.strokes.items():
                self.assertTrue(np.isfinite(stroke).all())
                middle = stroke[len(stroke) // 5 : -len(stroke) // 5]
                axis = np.stack(
                    [np.interp(np.linspace(0, 1, 2000), np.linspace(0, 1, len(axis)), c) for c in axis.T], 1
                )
                gap = np.linalg.norm(middle[:, None] - axis[None, :, :2], axis=2)
                at = gap.argmin(1)
                far = gap[np.arange(len(at)), at] / np.maximum(axis[at, 2], 5)
                self.assertLess(np.median(far), most[kind] + 0.02, f"{seed} {kind}")

    def test_strokes_lie_inside_unless_they_go_over(self):
        for seed, scene in self.scenes.items():
            near = cv2.dilate((scene.mask > 0).astype(np.uint8), np.ones((3, 3), np.uint8))
            for kind, stroke in scene.strokes.items():
                at = np.rint(stroke).astype(int)
                h, w = near.shape
                ok = (at >= 0).all(1) & (at[:, 0] < w) & (at[:, 1] < h)
                share = near[np.clip(at[:, 1], 0, h - 1), np.clip(at[:, 0], 0, w - 1)][ok].sum() / len(at)
                self.assertGreater(share, 0.75 if kind == "over" else 0.93, f"{seed} {kind}")

    def test_an_over_stroke_ends_outside_and_a_short_one_well_inside(self):
        r = np.random.default_rng(1)
        axis = np.stack([np.linspace(0, 100, 60), np.zeros(60), np.full(60, 20.0)], 1)
        over, short = strokes.stroke(r, axis, "over"), strokes.stroke(r, axis, "short")
        self.assertTrue(over[0, 0] < 0 and over[-1, 0] > 100)
        self.assertTrue(short[0, 0] > 8 and short[-1, 0] < 92)

    def test_the_mask_of_a_bar_has_its_area(self):
        points = np.stack([np.linspace(20.3, 150.3, 80), np.full(80, 60.2)], 1)
        cover = Solid(points, np.full(80, 14.0), np.full(80, 14.0)).coverage((200, 120))
        self.assertAlmostEqual(float(cover.sum()) / (130 * 28), 1.0, delta=0.01)

    def test_coordinates_are_those_of_the_line(self):
        points = np.stack([np.full(80, 60.0), np.linspace(20.0, 150.0, 80)], 1)
        solid = Solid(points, np.full(80, 14.0), np.full(80, 14.0))
        along, across = solid.coordinates((0, 0, 120, 180))
        self.assertAlmostEqual(float(along[85, 60]), 0.5, delta=0.01)
        self.assertAlmostEqual(abs(float(across[85, 67])), 0.5, delta=0.05)

    def test_sides_share_no_family_and_no_photo(self):
        self.assertFalse(set(photos.names("validation")) & set(photos.names("training")))
        seen = {side: set() for side in ("validation", "training")}
        for scene in self.scenes.values():
            names = (scene.said["spine"], scene.said["profile"], scene.said["look"])
            if scene.said["look"] == "cut_out":
                self.assertIn(scene.said["profile"], stamps.names(scene.said["side"], "long"))
                continue
            self.assertEqual(families.side_of(*names), scene.said["side"])
            seen[scene.said["side"]].add(scene.said["background"])
        both = {name for name in seen["validation"] & seen["training"] if name.startswith("photo:")}
        self.assertFalse(both)

    def test_both_sides_have_families_of_every_kind(self):
        for side in ("validation", "training"):
            r = np.random.default_rng(3)
            drawn = [families.pick(r, side) for _ in range(4000)]
            for index, names in enumerate((spines.FAMILIES, profiles.FAMILIES, looks.MATERIALS)):
                wanted = set(names) - (families.ONLY_VALIDATION if side == "training" else set())
                self.assertEqual({d[index] for d in drawn}, wanted)

    def test_a_case_says_what_the_format_asks_for(self):
        for scene in self.scenes.values():
            case = json.loads(json.dumps(make_scenes.case_of(scene)))
            for key in ("id", "category", "image", "mask", "width", "height", "ends", "difficulty", "spines", "axis"):
                self.assertIn(key, case)
            kinds = {"careful"} if case["category"] == "blank" else {"careful", "sloppy", "offcentre"}
            self.assertTrue(kinds <= set(case["spines"]))

    def test_made_grounds_fill_the_picture(self):
        for name, ground in grounds.MADE.items():
            picture = ground(np.random.default_rng(5), (130, 90))
            self.assertEqual(picture.shape, (90, 130, 3), name)
            self.assertTrue(np.isfinite(picture).all(), name)

    def test_a_projected_tube_has_the_width_that_its_distance_gives(self):
        profile = np.ones(30)
        vertices, quads, _ = meshes.turned(profile, 1.0, 0.1)
        facing = np.stack([[1.0, 0, 0], [0, 0, 1.0], [0, -1.0, 0]], 1)  # columns right, up, backwards: looking along +y
        camera = projecting.Camera(np.array([0, -50.0, 0.5]), facing, 10_000.0, np.zeros(2), (160, 260))
        cover = camera.cover(vertices, quads)
        self.assertAlmostEqual(float(cover.sum()) / (200 * 40), 1.0, delta=0.03)
        axis = projecting.measured(
            cover, camera.project(np.stack([0 * profile, 0 * profile, np.linspace(1, 0, 30)], 1))
        )
        self.assertAlmostEqual(float(np.median(axis[:, 2])), 40.0, delta=0.7)
        self.assertAlmostEqual(float(np.median(axis[:, 0])), 79.5, delta=0.5)

    def test_sides_share_no_model(self):
        paths = [
            {path for word in ("used", "clutter") for path, _ in models.names(side, word)}
            for side in ("validation", "training")
        ]
        self.assertTrue(paths[0] and paths[1])
        self.assertFalse(paths[0] & paths[1])


if __name__ == "__main__":
    unittest.main()
