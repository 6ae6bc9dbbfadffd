"""One scene: a function of (VERSION, seed). Everything random comes from one generator seeded with both."""

from dataclasses import dataclass, field

import cv2
import numpy as np

import damage
import drawings
import families
import grounds
import looks
import profiles
import spines
import stamps
import strokes
from colours import colour, lab_shift
from solids import Solid, room
from things import UNIT_STEPS, extent, make_solid, placed, rotation, unit_thing

VERSION = 5
FIRST_TRAINING_SEED = 10_000
NO_EDGE = (50, 120)  # Canny thresholds of "no edge nearby"


def side_of(seed):
    return "validation" if seed < FIRST_TRAINING_SEED else "training"


@dataclass
class Scene:
    seed: int
    picture: np.ndarray = None  # BGR uint8
    mask: np.ndarray = None  # 255 part, 128 do not care, 0 not
    visible: np.ndarray = None  # None where nothing hides the part
    solid: Solid = None
    strokes: dict = field(default_factory=dict)
    said: dict = field(default_factory=dict)  # what case.json says besides


def _size(r, low, high):
    """(w, h): log-uniform, mostly lying or standing as the thing does."""
    long_side = int(np.exp(r.uniform(np.log(270), np.log(1100))))
    short_side = int(long_side / r.choice([1.0, 4 / 3, 3 / 2, 16 / 9, r.uniform(1, 1.9)]))
    lies = high[0] - low[0] > high[1] - low[1]
    return (long_side, short_side) if lies == (r.random() < 0.85) else (short_side, long_side)


def lay(r, picture, solid, material, side, ground=None, base=None, bold=False):
    """Draws a solid into the picture (in place), `bold` = with strong paint. Returns its coverage [h, w] and base
    colour."""
    size = picture.shape[1::-1]
    cover = solid.coverage(size)
    x0, y0, x1, y1 = box = solid.box(size)
    if x1 - x0 < 3 or y1 - y0 < 3:
        return cover, colour(r)
    strip, base = looks.look(r, solid, material, side, base, bold)
    along, across = solid.coordinates(box)
    rows, columns = strip.picture.shape[:2]
    seen = cv2.remap(
        strip.picture,
        (across + looks.REACH) * np.float32((columns - 1) / (2 * looks.REACH)),
        along * np.float32(rows - 1),
        cv2.INTER_LINEAR,
        borderMode=cv2.BORDER_REPLICATE,
    )
    if solid.bulge:
        _mouth(r, seen, solid, box, base)
    if strip.wet and ground is not None:  # glass: the ground, displaced by the round
        x, y = np.meshgrid(np.arange(x0, x1, dtype=np.float32), np.arange(y0, y1, dtype=np.float32))
        lens = r.uniform(-1.5, 1.5) * np.median(solid.half) * across**3
        index = np.clip(along * (len(solid.normal) - 1), 0, len(solid.normal) - 1).astype(np.int32)
        normal = solid.normal.astype(np.float32)[index]
        through = cv2.remap(
            ground,
            x + lens * normal[..., 0],
            y + lens * normal[..., 1],
            cv2.INTER_LINEAR,
            borderMode=cv2.BORDER_REFLECT,
        )
        bright = np.clip(seen.max(2, keepdims=True) * 1.4 - 0.6, 0, 1)
        wet = strip.wet * (1 - bright) * np.clip(1.25 - np.abs(across)[..., None] ** 6, 0, 1)
        seen = seen + wet * (through * (0.55 + 0.45 * base) - seen)
    soft = cover[y0:y1, x0:x1, None]
    here = picture[y0:y1, x0:x1]
    here += soft * (np.clip(seen, 0, 1) - here)
    if material == "fur":
        _hairs(r, picture, seen, solid, box)
    return cover, base


def _mouth(r, seen, solid, box, base):
    """The open top, lid or foot of a turned thing seen from above or below."""
    at = 0 if solid.bulge > 0 else -1
    ellipse = np.rint((solid.mouth(at) - box[:2]) * 16).astype(np.int32)
    inner = np.float32(base) * r.uniform(0.15, 1.2)
    cv2.fillPoly(seen, [ellipse], inner.tolist(), cv2.LINE_AA, 4)
    if r.random() < 0.7:
        tone = np.float32(base) * r.uniform(0.6, 1.6)
        cv2.polylines(
            seen, [ellipse], True, np.clip(tone, 0, 1).tolist(), max(1, int(0.04 * solid.half[at])), cv2.LINE_AA, 4
        )


def _hairs(r, picture, seen, solid, box):
    """Hairs over the outline."""
    width = 2 * np.median(solid.half)
    long_hair = r.uniform(0.03, 0.15) * width
    for sign in (-1, 1):
        edge = solid.side(sign)
        for i in r.integers(0, len(edge), int(min(900, 1.5 * solid.length / max(1.0, 0.02 * width)))):
            root = edge[i] - solid.normal[i] * sign * r.uniform(0, 0.1) * solid.half[i]
            tip = root + (solid.normal[i] * sign * r.uniform(0.2, 1) + solid.tangent[i] * r.normal(0, 0.7)) * long_hair
            at = np.rint(root - box[:2]).astype(int)
            if 0 <= at[0] < seen.shape[1] and 0 <= at[1] < seen.shape[0]:
                cv2.line(
                    picture,
                    tuple(np.rint(root * 16).astype(int).tolist()),
                    tuple(np.rint(tip * 16).astype(int).tolist()),
                    np.clip(seen[at[1], at[0]] * r.uniform(0.8, 1.1), 0, 1).tolist(),
                    1,
                    cv2.LINE_AA,
                    4,
                )


def _shadow(r, picture, cover, width):
    """A cast shadow beside the thing."""
    move = np.float32([[1, 0, r.uniform(-0.5, 0.5) * width], [0, 1, r.uniform(-0.1, 0.5) * width]])
    shade = cv2.warpAffine(cover, move, cover.shape[::-1])
    shade = grounds.soft(shade, max(1.0, r.uniform(0.03, 0.3) * width))
    picture *= (1 - np.float32(r.uniform(0.15, 0.7)) * shade)[..., None]


def _ring_tone(picture, ring, far):
    """The mean colour of the pixels of a ring, spread over the picture."""
    mean = (picture * ring[..., None]).sum((0, 1)) / max(1e-6, float(ring.sum()))
    tone = grounds.soft(picture * ring[..., None], far)
    share = grounds.soft(ring, far)[..., None]
    return (tone + 0.02 * mean) / (share + 0.02)  # far from the ring the mean of all of it


def _blend_in(r, picture, cover, seen, width):
    """Moves the ground near the thing to within 2..12 Lab units of the thing's rim, all along it. `seen` = the thing
    drawn on the ground."""
    h, w = cover.shape
    scale = min(1.0, 160 / max(h, w))
    small = [cv2.resize(v, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA) for v in (picture, cover, seen)]
    ground, inside, thing = small
    reach = max(1, int(round(0.12 * width * scale)))
    kernel = np.ones((2 * reach + 1, 2 * reach + 1))
    far = max(1.5, 0.25 * width * scale)
    wanted = _ring_tone(thing, inside - cv2.erode(inside, kernel), far)
    outside = np.clip(cv2.dilate(inside, kernel) - inside, 0, 1)
    shift = wanted - _ring_tone(ground, outside, far)
    away = r.standard_normal(3)
    mean = np.clip(wanted[outside > 0.5].mean(0) if (outside > 0.5).any() else wanted.mean((0, 1)), 0, 1)
    shift += lab_shift(mean, *(away / np.linalg.norm(away) * r.uniform(2, 12))) - mean
    wide = grounds.soft(cv2.dilate(inside, kernel), far * r.uniform(1.5, 4))
    near_by = 1 - (1 - np.clip(wide, 0, 1)) ** 3
    picture += cv2.resize(shift * near_by[..., None], (w, h), interpolation=cv2.INTER_LINEAR)
    np.clip(picture, 0, 1, out=picture)


def outline_of(solid):
    """The outline in the picture [m, 2]: one side there, the other back."""
    return np.concatenate([solid.side(-1)[solid.shown], solid.side(1)[solid.shown][::-1]])


def _occluders(r, picture, solid, part, width, side, size):
    """Rods, fingers, leaves and cards in front. Returns what they cover."""
    hidden = np.zeros(size[::-1], np.float32)
    for _ in range(r.integers(1, 4)):
        if (hidden * part).sum() > 0.25 * part.sum():
            break
        centre = solid.points[r.integers(solid.shown.start, solid.shown.stop)] + r.uniform(-0.5, 0.5, 2) * width
        angle = r.uniform(0, 2 * np.pi)
        way = np.array([np.cos(angle), np.sin(angle)])
        kind = r.random()
        if kind < 0.35:  # fingers
            skin = cv2.cvtColor(
                np.float32([[[r.uniform(8, 28), r.uniform(0.25, 0.6), r.uniform(0.3, 0.95)]]]), cv2.COLOR_HSV2BGR
            )[0, 0]
            thick = width * r.uniform(0.12, 0.3)
            for k in range(r.integers(1, 5)):
                tip = centre + np.array([-way[1], way[0]]) * thick * 2.1 * k
                line = np.stack([tip, tip + way * max(size)])
                line = spines.resampled(line, 60)
                half = np.full(60, thick) * np.sqrt(np.clip(np.arange(60) * max(size) / 60 / thick, 0.02, 1))
                cover, _ = lay(r, picture, Solid(line, half, half), "plain", side, None, skin)
                hidden = np.maximum(hidden, cover)
        elif kind < 0.8:
            spine, profile = r.choice(["straight", "bend", "wander"]), r.choice(["rod", "branch", "spindle", "taper"])
            thing = make_solid(r, size, spine, profile, r.uniform(0.4, 1.2))
            thing.points += centre - thing.points[len(thing.points) // 2]
            most = r.uniform(0.1, 0.35) * width
            thing.half *= min(1.0, most / thing.half.max())
            cover, _ = lay(r, picture, thing, r.choice(["matte", "plain", "gloss", "photo"]), side)
            hidden = np.maximum(hidden, cover)
        else:  # a card or box
            sides = width * r.uniform(0.3, 0.8), min(width, 0.25 * solid.length) * r.uniform(0.3, 1.0)
            middle = tuple(map(float, centre + way * width * 0.5))
            corners = cv2.boxPoints((middle, sides, float(np.degrees(angle))))
            card = np.zeros(size[::-1], np.uint8)
            cv2.fillPoly(card, [np.int32(corners)], 255, cv2.LINE_AA)
            cover = card.astype(np.float32) / 255
            picture += cover[..., None] * (colour(r) - picture)
            hidden = np.maximum(hidden, cover)
    return hidden


def _extra(r, picture, solid, width, side, size, material):
    """Other things about: copies beside it, things behind, a handle. They go under the part."""
    if r.random() < 0.35:
        for _ in range(r.integers(1, 4)):
            twin = Solid(solid.points, solid.half, solid.half, solid.bulge, solid.ends)
            away = r.uniform(-1, 1, 2)
            twin.points = solid.points + away / np.linalg.norm(away) * width * r.uniform(1.05, 3)
            lay(r, picture, twin, material, side, picture.copy())
    if r.random() < 0.25:
        for _ in range(r.integers(1, 4)):
            thing = make_solid(r, size, *families.pick(r, side)[:2], r.uniform(0.2, 0.9))
            lay(r, picture, thing, r.choice(looks.MATERIALS[:6]), side, picture.copy())


def _handle(r, solid, width):
    """A bow at one side, as on mugs and jugs: not the part."""
    n = len(solid.points)
    a, b = int(n * r.uniform(0.08, 0.3)), int(n * r.uniform(0.6, 0.9))
    sign = r.choice([-1, 1])
    start, end = solid.side(sign)[a], solid.side(sign)[b]
    out = solid.normal[(a + b) // 2] * sign * np.linalg.norm(end - start) * r.uniform(0.4, 0.9)
    t = np.linspace(0, 1, 60)[:, None]
    line = (
        (1 - t) ** 3 * start + 3 * t * (1 - t) ** 2 * (start + out) + 3 * t * t * (1 - t) * (end + out) + t**3 * end
    )
    half = np.full(60, width * r.uniform(0.04, 0.1))
    return Solid(spines.resampled(line, 60), half, half)


def _body(r, solid, at, width):
    """What an open end goes on into: a rounded body around the end."""
    way = solid.tangent[at] * (-1 if at == 0 else 1)
    reach = width * r.uniform(0.8, 1.6)
    start = solid.points[at] + way * reach * r.uniform(0.75, 0.95)
    across = np.array([-way[1], way[0]]) * r.choice([-1, 1])
    tilt = r.uniform(-0.8, 0.8)
    way = way * np.cos(tilt) + across * np.sin(tilt)
    line = spines.resampled(np.stack([start - way * reach * 0.9, start + way * reach * r.uniform(1, 2.5)]), 80)
    u = np.linspace(0, 1, 80)
    half = reach * np.sqrt(np.maximum(1e-4, 1 - (2 * u - 1) ** 2)) * (1 + 0.1 * spines.wave(r, 80, 3))
    return Solid(line, half, half)


def _limbs(r, solid, width):
    """Twigs, leaves, fins and legs that grow out of a thing's sides: it is attached to them, they are not the part."""
    out = []
    for _ in range(r.integers(1, 6)):
        i, sign = int(r.integers(solid.shown.start, solid.shown.stop)), r.choice([-1, 1])
        root = solid.points[i] + solid.normal[i] * (sign * 0.4 * solid.half[i])
        way = solid.normal[i] * sign + solid.tangent[i] * r.normal(0, 0.7)
        way /= np.linalg.norm(way)
        far = solid.half[i] + width * r.uniform(0.2, 1.4)
        t = np.linspace(0, 1, 60)[:, None]
        bent = np.array([-way[1], way[0]]) * r.uniform(-0.5, 0.5) * far
        half = width * r.uniform(0.04, 0.22)
        shape = r.choice(["rod", "leaf"])
        thick = half * (np.sin(np.pi * (0.15 + 0.85 * t[:, 0])) ** 0.8 + 0.05 if shape == "leaf" else 1 - 0.6 * t[:, 0])
        out.append(Solid(spines.resampled(root + way * (t * far) + bent * t * t, 60), thick, thick))
    return out


def _mask_of(cover, care):
    mask = np.where(cover >= 0.5, 255, 0).astype(np.uint8)
    if care is not None:
        mask[(care >= 0.5) & (mask == 0)] = 128
    return mask


def _ground(r, size, side):
    """A photo or made ground, sometimes with cut-out things about: (picture, its name, whether it is a photo)."""
    over_photo = r.random() < 0.62
    if over_photo:
        picture, name = grounds.photo(r, size, side)
    else:
        name = families.pick_ground(r, side)
        picture = grounds.MADE[name](r, size)
    picture = np.ascontiguousarray(picture, np.float32)
    if r.random() < 0.22:
        for _ in range(r.integers(1, 4)):
            stamp = str(r.choice(stamps.names(side, "clutter")))
            seen, cover, _ = stamps.warped(r, stamp, size, r.uniform(0.15, 0.7))
            stamps.lay(picture, seen, cover)
    return picture, name, over_photo


def _attached(r, picture, solid, profile, material, side, width, base, tags):
    """What the part is attached to, under it: bodies at open ends, limbs, a handle. Returns the do-not-care cover or
    None."""
    care = None
    attached = [_body(r, solid, at, width) for at in (0, -1) if solid.ends[at] == "open"]
    if profile not in profiles.TURNED and r.random() < 0.2:
        attached += _limbs(r, solid, width)
        tags.append("limbs")
    for body in attached:
        cover, _ = lay(r, picture, body, material, side, picture.copy(), base)
        care = cover if care is None else np.maximum(care, cover)
    if profile in ("cup", "vase", "jar", "bottle") and r.random() < (0.75 if profile == "cup" else 0.2):
        lay(r, picture, _handle(r, solid, width), material, side, picture.copy(), base)
        tags.append("handle")
    return care


def _photo_like(r, seed, size, side, thing, profile, material):
    """A shaded thing over a photo or a made ground."""
    picture, ground_name, over_photo = _ground(r, size, side)
    solid = placed(r, thing, size)
    width = 2 * float(np.median(solid.half[solid.shown]))
    cover = solid.coverage(size)
    tags, base, bold = [], colour(r), r.random() < 0.12
    if r.random() < 0.45:
        _shadow(r, picture, cover, width)
        tags.append("shadow")
    _extra(r, picture, solid, width, side, size, material)
    care = _attached(r, picture, solid, profile, material, side, width, base, tags)
    layer = picture.copy()
    cover, _ = lay(r, layer, solid, material, side, picture, base, bold)
    said = {
        "category": "photo" if over_photo else "procedural",
        "background": ground_name,
        "tags": tags,
        "look": material,
    }
    return _spoiled(r, Scene(seed, solid=solid, said=said), picture, layer, cover, care, 0.7 if bold else 0.15)


def _cut_out(r, seed, size, side):
    """A photographed thing cut out and laid over a photo or a made ground; None where its middle line is not fair."""
    picture, ground_name, over_photo = _ground(r, size, side)
    layer = picture.copy()
    found = stamps.thing(r, layer, size, side)
    if found is None:
        return None
    cover, solid, name = found
    if r.random() < 0.4:
        plain = layer - picture * (1 - cover[..., None])
        _shadow(r, picture, cover, 2 * float(np.median(solid.half)))
        layer = plain + picture * (1 - cover[..., None])
    said = {
        "category": "photo" if over_photo else "procedural",
        "background": ground_name,
        "tags": ["cut_out"],
        "look": "cut_out",
        "spine": "straight",
        "profile": name,
    }
    return _spoiled(r, Scene(seed, solid=solid, said=said), picture, layer, cover, None, 0.15)


def _spoiled(r, scene, ground, picture, cover, care, blending):
    """The finished scene of a thing drawn on its ground: blended in, erased, bitten, hidden, photographed."""
    solid, side, size = scene.solid, side_of(scene.seed), cover.shape[::-1]
    width = 2 * float(np.median(solid.half[solid.shown]))
    if r.random() < blending:
        _blend_in(r, ground, cover, picture, width)
        scene.said["tags"].append("low_contrast")
        picture = ground * (1 - cover[..., None]) + picture * cover[..., None]
    outline = outline_of(solid)
    missing, hidden = 0.0, None
    if r.random() < 0.38:
        missing = 100 * damage.erase(r, picture, ground, outline, width, r.uniform(0.08, 0.55)).mean()
    if r.random() < 0.16:
        hidden = damage.bites(r, picture, ground, cover > 0.5, outline, width).astype(np.float32)
    if r.random() < 0.28:
        in_front = _occluders(r, picture, solid, cover, width, side, size)
        hidden = in_front if hidden is None else np.maximum(hidden, in_front)
    scene.picture, sigma = damage.camera(r, picture)
    scene.said |= {"missing": float(missing), "noise": sigma}
    finish(scene, solid, cover, care, hidden)
    return scene


def _drawing(r, seed, size, side, thing, profile):
    scene = Scene(seed)
    picture = np.ascontiguousarray(grounds.paper(r, size), np.float32)
    solid = placed(r, thing, size)
    width = 2 * float(np.median(solid.half[solid.shown]))
    cover = solid.coverage(size)
    ink = np.zeros(size[::-1], np.uint8)
    pen = drawings.Pen(r, picture)
    care = None
    for at in (0, -1):
        if solid.ends[at] == "open":
            body = _body(r, solid, at, width)
            body_cover = body.coverage(size)
            drawings.outline(r, pen, ink, body, 0.1)
            ink[cover > 0.5] = 0
            care = body_cover if care is None else np.maximum(care, body_cover)
    limbs = _limbs(r, solid, width) if profile not in profiles.TURNED and r.random() < 0.25 else []
    if r.random() < 0.3:  # other drawings on the sheet
        for _ in range(r.integers(1, 4)):
            other = make_solid(r, size, *families.pick(r, side)[:2], r.uniform(0.15, 0.8))
            layer = np.zeros_like(ink)
            drawings.outline(r, pen, layer, other, 0.0)
            layer[cover > 0.5] = 0
            ink = cv2.max(ink, layer)
    if profile == "cup" and r.random() < 0.7:
        drawings.outline(r, pen, ink, _handle(r, solid, width), 0.0)
        ink[cover > 0.5] = 0
    if r.random() < 0.4:
        drawings.fill(r, picture, solid, cover)
    share = r.uniform(0.05, 0.5) if r.random() < 0.5 else 0.0
    missing = 100 * drawings.outline(r, pen, ink, solid, share)
    joined = r.random() < 0.5  # no line where they grow out
    for limb in limbs:
        limb_cover = limb.coverage(size)
        layer = np.zeros_like(ink)
        drawings.outline(r, pen, layer, limb, 0.0)
        layer[cover > 0.5] = 0
        if joined:
            ink[limb_cover > 0.7] = 0
        ink = cv2.max(ink, layer)
        care = limb_cover if care is None else np.maximum(care, limb_cover)
    if r.random() < 0.6:
        drawings.details(r, pen, ink, solid)
    if r.random() < 0.4:
        ink = drawings.hatching(r, pen, ink, solid, cover)
    drawings.ink_on(r, picture, ink, pen)
    hidden = None
    if r.random() < 0.08:
        hidden = _occluders(r, picture, solid, cover, width, side, size)
    if r.random() < 0.5:
        scene.picture, sigma = damage.camera(r, picture)
    else:
        scene.picture, sigma = np.clip(picture * 255 + 0.5, 0, 255).astype(np.uint8), 0.0
    scene.said |= {
        "category": "sketch",
        "background": "paper",
        "missing": missing,
        "noise": sigma,
        "tags": ["drawing"],
        "look": "drawing",
        "tolerance": max(1.0, pen.thick / 2),
    }
    finish(scene, solid, cover, care, hidden)
    return scene


BLANK_SHARE = 0.04  # of all scenes
BLANK_HALF = 0.1  # half width of a part where the picture shows nothing, as a share of the stroke's length


def _clear_of(solid, other, size):
    """Whether `other` keeps at least half a width away from the solid."""
    return not (np.minimum(solid.coverage(size, solid.half.max()), other.coverage(size)) > 0).any()


def _blank(r, seed, size, side, spine):
    """A line where the picture shows nothing: empty paper or a plain ground, other things far off. What the part is
    then is a rule of the product, not a truth of the picture: the stroke with one width."""
    drawn = r.random() < 0.7
    ground = grounds.paper if drawn else grounds.MADE[r.choice(["studio", "wall"])]
    picture = np.ascontiguousarray(ground(r, size), np.float32)
    for _ in range(40):
        unit = spines.points_of(spines.FAMILIES[spine](r), r)
        line = spines.resampled(unit @ rotation(r.uniform(0, 2 * np.pi)).T, UNIT_STEPS)
        span = np.ptp(line, axis=0)
        line *= r.uniform(0.12, 0.8) * min(size[0] / span[0], size[1] / span[1])
        line += r.uniform(0.1, 0.9, 2) * (np.array(size) - np.ptp(line, axis=0)) - line.min(0)
        length = np.linalg.norm(np.diff(line, axis=0), axis=1).sum()
        half = np.full(len(line), BLANK_HALF * length)
        if length > 40 and room(line, half, half):
            break
        spine = "straight"
    way = [line[0] - line[4], line[-1] - line[-5]]
    tips = [end + w / np.linalg.norm(w) * half[0] for end, w in zip((line[0], line[-1]), way)]
    axis = spines.resampled(np.concatenate([tips[:1], line, tips[1:]]), UNIT_STEPS)
    place = np.arange(UNIT_STEPS) * 1.2 * length / (UNIT_STEPS - 1)
    from_tip = np.minimum(place, place[::-1]) / half
    half = np.maximum(0.3, half * np.sqrt(np.clip(1 - (1 - np.minimum(from_tip, 1)) ** 2, 0, 1)))
    solid = Solid(axis, half, half)
    ink, pen = np.zeros(size[::-1], np.uint8), drawings.Pen(r, picture)
    for _ in range(r.choice([0, 1, 2, 4])):
        other = make_solid(r, size, *families.pick(r, side)[:2], r.uniform(0.08, 0.6))
        if not _clear_of(solid, other, size):
            continue
        if drawn:
            drawings.outline(r, pen, ink, other, r.choice([0.0, 0.3]))
        else:
            lay(r, picture, other, r.choice(["matte", "plain", "gloss"]), side)
    if drawn:
        drawings.ink_on(r, picture, ink, pen)
    scene = Scene(seed)
    scene.picture, sigma = damage.camera(r, picture)
    scene.said = {
        "category": "blank",
        "background": "paper" if drawn else ground.__name__,
        "missing": 100.0,
        "noise": sigma,
        "tags": ["blank"],
        "look": "blank",
        "profile": "even",
    }
    finish(scene, solid, solid.coverage(size), None, None)
    scene.strokes = {"careful": line[:: max(1, len(line) // 80)]}
    return scene


def finish(scene, solid, cover, care, hidden):
    """Masks of the part, whole and visible."""
    scene.solid = solid
    scene.mask = _mask_of(cover, care)
    if hidden is not None:
        scene.visible = scene.mask.copy()
        scene.visible[hidden >= 0.5] = 0
        part = scene.mask == 255
        scene.said["occlusion"] = 100.0 * float((part & (scene.visible != 255)).sum()) / max(1, part.sum())


def make(seed):
    """The scene of a seed."""
    cv2.setNumThreads(1)
    r = np.random.default_rng([VERSION, seed])
    side = side_of(seed)
    kind = r.random()
    drawn = kind < 0.3
    spine, profile, material = families.pick(r, side, drawn)
    thing = unit_thing(r, spine, profile)
    size = _size(r, *extent(thing))
    scene = _cut_out(r, seed, size, side) if kind > 0.93 else None
    if kind < BLANK_SHARE:
        scene = _blank(r, seed, size, side, spine)
    elif drawn:
        scene = _drawing(r, seed, size, side, thing, profile)
    elif scene is None:
        scene = _photo_like(r, seed, size, side, thing, profile, material)
    quality = int(r.integers(45, 98)) if scene.said["noise"] > 0 else 97
    scene.said = {"spine": spine, "profile": profile, "side": side, "quality": quality} | scene.said
    if not scene.strokes:
        scene.strokes = strokes.strokes_of(r, scene.solid.axis(), size)
    return scene
