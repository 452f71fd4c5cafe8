# SPDX-License-Identifier: GPL-3.0-or-later
"""An ammonite: a ribbed tube wound on a logarithmic spiral.

The coil lies in the xy plane, its mouth at angle 0 of the last whorl where the
spiral's radius is 1; one unit is that radius.
"""

import numpy as np

from .polygonise import sculpt
from .sdf import carve, clip, join, smoothstep

GROWTH = np.log(2.0) / (2.0 * np.pi)  # each whorl is 2.0 times the one inside it
WIDE, TALL = 0.33, 0.37               # half sizes of the section, across and along the radius
WHORLS = 4
MOUTH = np.radians(-25.0)               # direction of the aperture
RIBS = 27                               # per whorl


def _whorl(radius, turn, z, ribs=True, thick=0.0):
    """Distance to the tube at unwound angle `turn` (0 at the mouth, negative inward)."""
    size = np.exp(GROWTH * turn)
    u = (radius - size) / size          # along the radius, in section units
    w = z / size
    across = np.arctan2(w, u)           # 0 on the outer edge (venter), pi towards the centre
    # a slightly square section with flattened flanks
    flat = 2.4
    lip = 1.0 + 0.05 * np.exp(-(turn / 0.07) ** 2)
    u, w = u / lip, w / lip
    k = (np.abs(u / (TALL - thick)) ** flat + np.abs(w / (WIDE - thick)) ** flat + 1e-12) ** (1.0 / flat)
    section = (k - 1.0) * 0.30
    if ribs:
        # ribs sweep forward over the flank, and fade on the keel and in the smallest whorls
        bend = 0.16 * np.cos(across) + 0.05 * np.cos(2.0 * across)
        phase = RIBS * (turn - bend)
        crest = (0.5 + 0.5 * np.cos(phase)) ** 1.4
        flank = smoothstep(3.05, 2.1, np.abs(across)) * smoothstep(0.10, 0.34, np.abs(across))
        grow = smoothstep(-24.0, -9.0, turn)
        section = section - (0.055 * crest - 0.02) * flank * grow
        section = section + 0.02 * np.exp(-(across / 0.16) ** 2) * grow       # furrow beside the keel
        section = section - 0.060 * np.exp(-(across / 0.085) ** 2) * grow      # keel
    return section * size


def ammonite(p):
    x, y, z = p.T
    radius = np.hypot(x, y)
    angle = np.mod(np.arctan2(y, x) - MOUTH, 2.0 * np.pi) - 2.0 * np.pi   # in [-2 pi, 0)
    # the last whorl: cut at the mouth, hollow behind it
    d = np.full(len(p), 1e3)
    for turn in (angle + 2.0 * np.pi, angle):
        ahead = np.clip(turn, -1.5, 1.5) * radius
        outer = clip(_whorl(radius, turn, z), ahead, 0.03)
        inner = clip(_whorl(radius, turn, z, ribs=False, thick=0.045), -ahead - 0.75, 0.25)
        d = np.minimum(d, carve(outer, inner, 0.025))
    # the whorls inside it
    for whorl in range(1, WHORLS + 1):
        turn = angle - 2.0 * np.pi * whorl
        d = join(d, _whorl(radius, turn, z), 0.035 * np.exp(GROWTH * turn))
    heart = np.exp(-GROWTH * 2 * np.pi * (WHORLS + 0.3))
    return join(d, np.sqrt(radius ** 2 + z ** 2) - heart, 0.02)


def build(quality=1.0):
    h = 0.0135 / quality
    mesh = sculpt(ammonite, (-1.5, -1.5, -0.6), (1.6, 1.5, 0.6), h, faces=int(38000 * min(1, quality ** 2)))
    lo, hi = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    scale = 2.0 / (hi - lo).max()
    return mesh.moved(scale, -scale * (lo + hi) / 2)
