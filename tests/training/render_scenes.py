"""Scenes rendered with Blender's Cycles: `blender -b -P render_scenes.py -- --seeds A:B --out DIR [--samples N]`.

A thing (turned, swept or a furniture model) stands or lies on a table among others, under a photo's light. The mask is
the projection of its mesh, whole also where something stands before it."""

import argparse
import os
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import bpy  # noqa: E402
import cv2  # noqa: E402
import numpy as np  # noqa: E402
from mathutils import Matrix, Vector  # noqa: E402

import damage  # noqa: E402
import families  # noqa: E402
import grounds  # noqa: E402
import looks  # noqa: E402
import make_scenes  # noqa: E402
import meshes  # noqa: E402
import models  # noqa: E402
import photos  # noqa: E402
import profiles  # noqa: E402
import projecting  # noqa: E402
import scene as scenes  # noqa: E402
import spines  # noqa: E402
import strokes  # noqa: E402
import things  # noqa: E402
from colours import colour, near  # noqa: E402

STREAM = 7  # keeps these seeds apart from make_scenes' generator
MATERIALS = ("gloss", "matte", "metal", "glass", "ceramic", "wood", "photo", "plain")


# Pictures and materials.


def image_of(picture):
    """A Blender image of a BGR float picture."""
    h, w = picture.shape[:2]
    image = bpy.data.images.new("made", w, h)
    pixels = np.ones((h, w, 4), np.float32)
    pixels[..., :3] = np.clip(picture[::-1, :, ::-1], 0, 1)
    image.pixels.foreach_set(pixels.ravel())
    image.pack()
    return image


def material_of(r, kind, picture=None, base=None):
    """A Principled material of one kind, its colour from a picture or even."""
    material = bpy.data.materials.new(kind)
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    shader = nodes["Principled BSDF"]
    if picture is not None:
        texture = nodes.new("ShaderNodeTexImage")
        texture.image = image_of(picture)
        links.new(texture.outputs["Color"], shader.inputs["Base Color"])
    else:
        tone = colour(r) if base is None else base
        shader.inputs["Base Color"].default_value = (*[float(v) ** 2.2 for v in tone[::-1]], 1)
    shader.inputs["Roughness"].default_value = {
        "gloss": r.uniform(0.03, 0.3),
        "ceramic": r.uniform(0.1, 0.35),
        "glass": r.uniform(0, 0.08),
        "metal": r.uniform(0.05, 0.45),
    }.get(kind, r.uniform(0.4, 1))
    shader.inputs["Metallic"].default_value = 1.0 if kind == "metal" else 0.0
    shader.inputs["Transmission"].default_value = r.uniform(0.8, 1) if kind == "glass" else 0.0
    shader.inputs["Clearcoat"].default_value = float(kind == "ceramic")
    if r.random() < 0.2 and kind in ("matte", "wood", "plain"):
        bump, noise = nodes.new("ShaderNodeBump"), nodes.new("ShaderNodeTexNoise")
        noise.inputs["Scale"].default_value = r.uniform(4, 60)
        bump.inputs["Strength"].default_value = r.uniform(0.1, 0.6)
        links.new(noise.outputs["Fac"], bump.inputs["Height"])
        links.new(bump.outputs["Normal"], shader.inputs["Normal"])
    return material


def paint(r, kind, side, base):
    """The picture wrapped about a thing, without light."""

    strip = looks.blank(700.0, np.full(100, 90.0), base)
    if kind == "photo":
        looks.photo_texture(r, strip, side)
    if kind == "wood":
        looks.grain(r, strip, base)
    for name in r.choice(list(looks.PATTERNS), r.integers(0, 4)):
        looks.PATTERNS[name](r, strip, base)
    return np.clip(strip.picture, 0, 1)


def object_of(name, vertices, quads, uv, material):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices.tolist(), [], [list(dict.fromkeys(q)) for q in quads.tolist()])
    layer = mesh.uv_layers.new()
    corner = np.zeros(len(mesh.loops), np.int32)
    mesh.loops.foreach_get("vertex_index", corner)
    layer.data.foreach_set("uv", uv[corner].astype(np.float32).ravel())
    mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))
    mesh.update()
    thing = bpy.data.objects.new(name, mesh)
    thing.data.materials.append(material)
    bpy.context.collection.objects.link(thing)
    return thing


def dressed(r, side, kind):
    base = colour(r)
    picture = paint(r, kind, side, base) if kind not in ("glass", "metal") or r.random() < 0.25 else None
    return material_of(r, kind, picture, near(r, np.float32([0.9, 0.9, 0.9]), 0.1) if kind == "glass" else base)


# Things. Each is about one unit long, on the plane z = 0, and comes with the ends of its axis or the whole of it.


def turned_thing(r, side, kind, profile):
    shape = profiles.FAMILIES[profile](r)
    radius = 0.5 / (shape.slender * r.uniform(0.85, 1.15))
    hollow = r.uniform(0.04, 0.12) if kind == "glass" or profile in ("cup", "vase", "goblet") else None
    vertices, quads, uv = meshes.turned(shape.left, 1.0, radius, hollow)
    material = dressed(r, side, kind)
    thing = object_of("turned", vertices, quads, uv, material)
    axis = np.stack([np.zeros(120), np.zeros(120), np.linspace(1, 0, 120)], 1)
    if profile == "cup" and r.random() < 0.7:
        turn, out = r.uniform(-0.7, 0.7) + (np.pi if r.random() < 0.5 else 0), radius * r.uniform(0.4, 0.8)
        t = np.linspace(0, np.pi, 40)
        reach, z = radius * 0.85 + out * np.sin(t), 0.5 + 0.32 * np.cos(t)
        line = np.stack([reach * np.cos(turn), reach * np.sin(turn), z], 1)
        along = np.gradient(line, axis=0)
        along /= np.linalg.norm(along, axis=1, keepdims=True)
        flat = np.tile([-np.sin(turn), np.cos(turn), 0], (40, 1))
        half = np.full(40, radius * r.uniform(0.07, 0.14))
        object_of("handle", *meshes.sweep(line, flat, np.cross(flat, along), half, half), material)
    return thing, axis


def swept_thing(r, side, kind, spine, profile):
    unit, left, right, shape = things.unit_thing(r, spine, profile)
    unit = unit - (unit.min(0) + unit.max(0)) / 2
    tangent, normal = spines.frame(unit)
    height = r.uniform(0.45, 1.1)
    rest = height * np.maximum(left, right) * 0.98
    line = np.concatenate([unit, rest[:, None]], 1)
    flat = np.concatenate([normal, np.zeros((len(unit), 1))], 1)
    up = np.tile([0, 0, 1.0], (len(unit), 1))
    return object_of("swept", *meshes.sweep(line, flat, up, right, left, height), dressed(r, side, kind)), line


def model_thing(r, path, along, fresh_look, side):
    """A furniture model, its long axis upright, one unit high."""
    before = set(bpy.data.objects)
    bpy.ops.wm.obj_import(filepath=path, forward_axis="NEGATIVE_Z", up_axis="Y")
    parts = [o for o in bpy.data.objects if o not in before and o.type == "MESH"]
    for other in parts:
        other.select_set(True)
    bpy.context.view_layer.objects.active = parts[0]
    if len(parts) > 1:
        bpy.ops.object.join()
    thing = bpy.context.view_layer.objects.active
    bpy.ops.object.transform_apply()
    count = len(thing.data.vertices)
    points = np.zeros(count * 3, np.float32)
    thing.data.vertices.foreach_get("co", points)
    points = points.reshape(-1, 3)
    upright = {1: (0, 1, 2), 0: (1, 2, 0), 2: (2, 0, 1)}[along]  # the file's y is z here, its z is -y
    points = points[:, upright]
    low, high = points.min(0), points.max(0)
    points = (points - [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]]) / max(1e-6, high[2] - low[2])
    thing.data.vertices.foreach_set("co", points.astype(np.float32).ravel())
    thing.data.update()
    if fresh_look:
        thing.data.materials.clear()
        thing.data.materials.append(material_of(r, r.choice(["gloss", "matte", "metal", "ceramic"])))
    axis = np.stack([np.zeros(120), np.zeros(120), np.linspace(1, 0, 120)], 1)
    return thing, axis


# The stage.


def ground_picture(r, side):
    size = (int(r.integers(300, 700)), int(r.integers(300, 700)))
    if r.random() < 0.5:
        return grounds.photo(r, size, side)
    name = families.pick_ground(r, side)
    return grounds.MADE[name](r, size), name


def plane(name, corners, picture, r):
    uv = np.float32([[0, 0], [1, 0], [1, 1], [0, 1]]) * (r.uniform(1, 4) if r.random() < 0.4 else 1)
    return object_of(
        name,
        np.float64(corners),
        np.array([[0, 1, 2, 3]]),
        uv,
        material_of(r, r.choice(["matte", "plain", "gloss"]), picture),
    )


def stage(r, side, lying):
    """Table, backdrop and light. Returns the name of what is seen most."""
    table, table_name = ground_picture(r, side)
    far = r.uniform(2.0, 6)
    plane("table", [(-far, -far, 0), (far, -far, 0), (far, far, 0), (-far, far, 0)], table, r)
    name = table_name
    if not lying and r.random() < 0.75:
        back, name = ground_picture(r, side)
        y = r.uniform(0.8, far)
        plane("backdrop", [(-far, y, -0.2), (far, y, -0.2), (far, y, far), (-far, y, far)], back, r)
    world = bpy.data.worlds.new("world")
    world.use_nodes = True
    bpy.context.scene.world = world
    nodes = world.node_tree.nodes
    light = nodes["Background"]
    light.inputs["Strength"].default_value = r.uniform(0.25, 1.1)
    if r.random() < 0.7:
        texture = nodes.new("ShaderNodeTexEnvironment")
        picture = photos.read(r.choice(photos.names(side)))
        texture.image = image_of(cv2.resize(picture, (512, 256), interpolation=cv2.INTER_AREA).astype(np.float32) / 255)
        world.node_tree.links.new(texture.outputs["Color"], light.inputs["Color"])
    else:
        light.inputs["Color"].default_value = (*[float(v) for v in near(r, np.float32([0.8, 0.8, 0.8]), 0.2)], 1)
    for _ in range(r.integers(1, 4)):
        lamp = bpy.data.lights.new("lamp", "AREA")
        lamp.energy, lamp.size = float(np.exp(r.uniform(np.log(15), np.log(220)))), r.uniform(0.1, 2.5)
        lamp.color = [float(v) for v in near(r, np.float32([0.9, 0.9, 0.9]), 0.1)]
        holder = bpy.data.objects.new("lamp", lamp)
        angle, height = r.uniform(0, 2 * np.pi), r.uniform(0.6, 3)
        holder.location = (2.5 * np.cos(angle), 2.5 * np.sin(angle), height)
        holder.rotation_euler = (-Vector(holder.location) + Vector((0, 0, 0.4))).to_track_quat("-Z", "Y").to_euler()
        bpy.context.collection.objects.link(holder)
    return name


def clutter(r, side, lying, target_reach):
    """Other things about the target. Returns their objects."""
    out = []
    shelf = models.names(side) + models.names(side, "clutter")
    for _ in range(r.choice([0, 0, 1, 2, 3, 5, 7])):
        kind = r.choice(MATERIALS)
        choice = r.random()
        try:
            if choice < 0.4:
                path, along = shelf[r.integers(len(shelf))]
                thing, _ = model_thing(r, path, along, r.random() < 0.3, side)
            elif choice < 0.75:
                thing, _ = turned_thing(r, side, kind, r.choice(profiles.TURNED))
            else:
                thing, _ = swept_thing(r, side, kind, *[str(v) for v in families.pick(r, side)[:2]])
        except (RuntimeError, IndexError):
            continue
        thing.scale = (r.uniform(0.3, 1.2),) * 3
        angle, away = r.uniform(0, 2 * np.pi), target_reach + r.uniform(0.15, 1.3)
        thing.location = (away * np.cos(angle), away * np.sin(angle), 0)
        thing.rotation_euler = (0, 0, r.uniform(0, 2 * np.pi))
        out.append(thing)
    return out


def look_at(r, size, points, lying):
    """A camera that sees `points` [n, 3] as large as the picture allows."""
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    bpy.context.collection.objects.link(camera)
    middle = (points.min(0) + points.max(0)) / 2
    height = np.radians(r.uniform(48, 90) if lying else r.uniform(2, 38))
    turn = r.uniform(0, 2 * np.pi) if lying else r.normal(0, 0.3) - np.pi / 2
    away = r.uniform(1.8, 5)
    camera.location = middle + away * np.array(
        [np.cos(height) * np.cos(turn), np.cos(height) * np.sin(turn), np.sin(height)]
    )
    facing = (Vector(middle) - camera.location).to_track_quat("-Z", "Y").to_matrix()
    roll = r.uniform(0, 2 * np.pi) if lying else np.radians(r.normal(0, 6))
    facing = facing @ Matrix.Rotation(roll, 3, "Z")
    camera.rotation_euler = facing.to_euler()
    flat = (points - np.array(camera.location)) @ np.array(facing)
    seen = flat[:, :2] / -flat[:, 2:]
    low, high = seen.min(0), seen.max(0)
    w, h = size
    fill = 1 - 0.4 * r.random() ** 1.5
    focal = fill * 0.97 * min(w / (high[0] - low[0]), h / (high[1] - low[1]))  # px
    camera.data.sensor_fit, camera.data.sensor_width = "HORIZONTAL", 36
    camera.data.lens = focal * 36 / w
    spare = np.array([w, h]) - focal * (high - low)
    centre = (low + high) / 2 * focal + r.uniform(-0.35, 0.35, 2) * spare
    camera.data.shift_x, camera.data.shift_y = centre[0] / max(w, h), centre[1] / max(w, h)
    if w < h:
        camera.data.shift_x, camera.data.shift_y = centre[0] / w, centre[1] / w
    bpy.context.scene.camera = camera
    return projecting.Camera(np.array(camera.location), np.array(facing), focal, centre, size)


def settings(size, samples, r):
    world = bpy.context.scene
    world.render.engine = "CYCLES"
    world.cycles.device, world.cycles.samples = "CPU", samples
    world.cycles.use_adaptive_sampling, world.cycles.adaptive_threshold = True, 0.05
    world.cycles.max_bounces, world.cycles.diffuse_bounces, world.cycles.glossy_bounces = 6, 2, 3
    world.cycles.transmission_bounces, world.cycles.caustics_reflective, world.cycles.caustics_refractive = (
        6,
        False,
        False,
    )
    world.cycles.sample_clamp_indirect = 3
    world.cycles.seed = int(r.integers(1 << 30))
    world.render.threads_mode, world.render.threads = "FIXED", 1
    world.render.resolution_x, world.render.resolution_y = size
    world.view_settings.view_transform = str(r.choice(["Standard", "Filmic"]))
    world.view_settings.exposure = r.uniform(-0.5, 0.6)
    world.cycles.use_denoising = False  # Debian's Blender has no denoiser; smoothed() takes its place
    world.render.image_settings.file_format = "PNG"


def world_mesh(thing):
    """Vertices [n, 3] in the world and faces of an object."""
    bpy.context.view_layer.update()
    points = np.array([thing.matrix_world @ v.co for v in thing.data.vertices])
    return points, [list(p.vertices) for p in thing.data.polygons]


def make(seed, samples):
    """One rendered scene, or None where no fair view came of it."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    r = np.random.default_rng([scenes.VERSION, STREAM, seed])
    side = scenes.side_of(seed)
    kind = str(r.choice(MATERIALS))
    shelf = models.names(side)
    choice = r.random()
    lying = False
    if choice < 0.25 and shelf:
        path, along = shelf[r.integers(len(shelf))]
        thing, axis = model_thing(r, path, along, r.random() < 0.35, side)
        profile, spine, kind = Path(path).stem, "straight", "model"
    elif choice < 0.6:
        while True:
            profile = str(r.choice(profiles.TURNED))
            if families.side_of("straight", profile, kind) == side:
                break
            kind = str(r.choice(MATERIALS))
        spine = "straight"
        thing, axis = turned_thing(r, side, kind, profile)
    else:
        while True:
            spine, profile, kind = families.pick(r, side)
            if kind in MATERIALS:
                break
        thing, axis = swept_thing(r, side, kind, spine, profile)
        lying = True
    points, faces = world_mesh(thing)
    background = stage(r, side, lying)
    others = clutter(r, side, lying, np.abs(points[:, :2]).max())
    size = (int(np.exp(r.uniform(np.log(270), np.log(400)))), int(np.exp(r.uniform(np.log(270), np.log(400)))))
    camera = look_at(r, size, points, lying)
    settings(size, samples, r)
    cover = camera.cover(points, faces)
    hidden = np.zeros_like(cover)
    for other in others:
        where, shape = world_mesh(other)
        covers = camera.cover(where, shape)
        nearer = np.linalg.norm(where.mean(0) - camera.place) < np.linalg.norm(points.mean(0) - camera.place)
        share = (covers * cover).sum() / max(1, cover.sum())
        if nearer and share > 0.3:
            bpy.data.objects.remove(other)
        elif nearer:
            hidden = np.maximum(hidden, covers)
    line = projecting.measured(cover, camera.project(axis))
    if line is None or (cover > 0.5).mean() < 0.01:
        return None
    with tempfile.TemporaryDirectory() as folder:
        bpy.context.scene.render.filepath = folder + "/r.png"
        bpy.ops.render.render(write_still=True)
        picture = smoothed(cv2.imread(folder + "/r.png")).astype(np.float32) / 255
    return finished(r, seed, side, picture, cover, hidden, line, (spine, profile, kind), background)


def smoothed(picture):
    """Takes off most of the few samples' noise and keeps edges, as a camera's own processing does."""
    return cv2.bilateralFilter(cv2.medianBlur(picture, 3), 7, 22, 3)


def finished(r, seed, side, picture, cover, hidden, axis, names, background):
    """Damage, camera, strokes and what case.json says."""
    scene = scenes.Scene(seed)
    scene.solid = projecting.Measured(axis)
    width = float(np.median(axis[:, 2]))
    missing = 0.0
    if r.random() < 0.3:
        behind = projecting.without(picture, cover)
        gone = damage.erase(r, picture, behind, scenes.outline_of(scene.solid), width, r.uniform(0.08, 0.5))
        missing = 100 * gone.mean()
    scene.picture, sigma = damage.camera(r, picture)
    scene.said = {
        "category": "render3d",
        "background": background,
        "missing": missing,
        "noise": sigma,
        "tags": ["render"],
        "look": names[2],
        "spine": names[0],
        "profile": names[1],
        "side": side,
        "quality": int(r.integers(60, 98)),
    }
    scenes.finish(scene, scene.solid, cover, None, hidden if hidden.any() else None)
    scene.strokes = strokes.strokes_of(r, axis, scene.mask.shape[::-1])
    return scene


def main():
    say = argparse.ArgumentParser(description=__doc__)
    say.add_argument("--seeds", required=True, help="FIRST:END, END not included; from 10000 on they are for training")
    say.add_argument("--out", type=Path, required=True)
    say.add_argument("--samples", type=int, default=8)
    given = say.parse_args(sys.argv[sys.argv.index("--") + 1 :])
    first, end = map(int, given.seeds.split(":"))
    cv2.setNumThreads(1)
    start, made = time.process_time(), 0
    for seed in range(first, end):
        scene = make(seed, given.samples)
        if scene:
            make_scenes.write(scene, given.out / f"{seed:06d}")
            made += 1
    print(f"{made} renders, {(time.process_time() - start) / max(1, made):.2f} CPU s each")


if __name__ == "__main__":
    main()
