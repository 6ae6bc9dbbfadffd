"""Which kinds of things and made grounds belong to which side: no combination, and some families not at all, on
both."""

import hashlib

import looks
import profiles
import spines
from grounds import MADE

VALIDATION_SHARE = 0.15
OWN_SHARE = 0.12  # of validation's draws of its own families, those that are kept: they are a part of it, not most
# Families that only validation has: the network never sees one.
ONLY_VALIDATION = {"spiral", "goblet", "pear", "facets", "tiles"}


def side_of(*names):
    """The side of a combination: by its name's hash, or validation's where it contains one of its own families."""
    if ONLY_VALIDATION.intersection(names):
        return "validation"
    digest = hashlib.sha256("/".join(names).encode()).digest()
    return "validation" if digest[0] / 256 < VALIDATION_SHARE else "training"


def _spine_for(r, turned):
    if turned and r.random() < 0.8:
        return "straight" if r.random() < 0.85 else "bend"
    return r.choice(list(spines.FAMILIES))


def pick(r, side, drawn=False):
    """A random (spine, profile, material) of one side."""
    while True:
        profile = r.choice(list(profiles.FAMILIES))
        spine = _spine_for(r, profile in profiles.TURNED)
        material = "drawing" if drawn else r.choice(looks.MATERIALS)
        own = ONLY_VALIDATION.intersection((spine, profile, material))
        if own and r.random() > OWN_SHARE:
            continue
        if side_of(spine, profile, material) == side:
            return str(spine), str(profile), str(material)


def pick_ground(r, side):
    """A random made ground; validation has one of its own besides the common ones."""
    names = [n for n in MADE if side == "validation" or n not in ONLY_VALIDATION]
    return str(r.choice(names))
