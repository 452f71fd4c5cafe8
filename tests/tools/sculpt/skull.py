# SPDX-License-Identifier: GPL-3.0-or-later
"""A human skull after craniometric landmarks, in centimetres.

The frame is the anatomist's: y = 0 is the Frankfurt plane (lower orbit rim to
ear opening), z = 0 the ear openings, +z the face, x = 0 the midline. The
result is scaled to about two units of height and centred.
"""

import numpy as np

from . import sdf
from .polygonise import merged, sculpt
from .sdf import (bump, capsule, carve, clip, ellipsoid, join, join_all, mirrored, rounded_box,
                  smooth_abs, smoothstep, sphere, tube, vec)

JAW_OPEN = 6.0  # degrees
JAW_PIVOT = vec(0.0, -0.5, 1.3)

# Centre lines of the tooth rows, (x, z) from the midline back.
UPPER_ROW = sdf.Arch([(0, 9.35), (1.1, 9.05), (2.1, 8.15), (2.72, 6.9), (3.0, 5.5), (3.05, 4.2)])
LOWER_ROW = sdf.Arch([(0, 9.0), (0.95, 8.75), (1.85, 7.95), (2.5, 6.7), (2.85, 5.3), (3.15, 4.0)])
JAW_LINE = sdf.Arch([(0, 8.75), (1.25, 8.35), (2.3, 7.3), (3.1, 5.8), (3.8, 4.2), (4.45, 2.6),
                     (4.9, 1.0), (5.1, 0.0)])

# Teeth from the midline: kind, crown height, width along the row, thickness.
UPPER_TEETH = [("incisor", 1.18, 0.90, 0.74), ("incisor", 1.04, 0.72, 0.66), ("canine", 1.18, 0.80, 0.86),
               ("premolar", 0.86, 0.71, 0.92), ("premolar", 0.82, 0.69, 0.92),
               ("molar", 0.78, 1.03, 1.12), ("molar", 0.74, 0.98, 1.10)]
LOWER_TEETH = [("incisor", 0.98, 0.57, 0.62), ("incisor", 1.00, 0.62, 0.66), ("canine", 1.14, 0.72, 0.80),
               ("premolar", 0.88, 0.71, 0.78), ("premolar", 0.84, 0.72, 0.82),
               ("molar", 0.78, 1.12, 1.05), ("molar", 0.74, 1.06, 1.02)]
UPPER_GUM, LOWER_GUM = -4.05, -5.95  # where bone ends, y


# --- cranium ---------------------------------------------------------------

def vault(p):
    """Brain case: an egg, broadest behind the ears, with its eminences."""
    q = mirrored(p, 0.3)
    # narrower towards the forehead
    q[:, 0] /= 1.0 - 0.17 * smoothstep(0.0, 9.5, q[:, 2]) + 0.03 * bump(q[:, 2], -2.0, 4.0)
    d = ellipsoid(q, (0, 4.9, 0.3), (6.75, 7.2, 8.5))
    d = join(d, ellipsoid(q, (2.1, 6.1, -2.2), (4.85, 5.0, 5.3)), 1.6)      # parietal
    d = join(d, ellipsoid(q, (1.3, 6.4, 4.3), (3.7, 3.4, 4.35)), 2.0)        # frontal
    d = join(d, ellipsoid(q, (0.0, 3.4, -3.6), (4.9, 4.0, 4.75)), 1.5)       # occipital
    d = join(d, ellipsoid(q, (1.9, 0.2, -3.6), (3.0, 2.5, 3.5)), 1.2)        # below the nuchal line
    # the field of the temporal muscle lies a little deeper: the temporal lines
    field = np.hypot((p[:, 2] + 0.3) / 7.3, (p[:, 1] - 2.4) / 6.1)
    side = smoothstep(2.5, 4.5, q[:, 0]) * (0.25 + 0.75 * smoothstep(-5.0, 3.0, p[:, 2]))
    return d + 0.20 * (1.0 - smoothstep(0.84, 1.04, field)) * side


def orbit_frame(q):
    """Points in the eye socket's own axes, scaled so that its rim is 1.

    Returns the size (0 at the axis, 1 at the wall) and the depth in cm.
    """
    rows = sdf.frame((0.26, 0.05, 1.0))
    local = (q - vec(3.3, 1.72, 7.9)) @ (sdf.turn("z", 9.0) @ rows).T
    u, v, w = local.T
    depth = -w
    shrink = np.clip(1.0 - np.clip(depth, -0.6, None) / 6.8, 0.05, None) ** 0.72
    # the roof slopes down to an apex low and towards the nose
    v = v + 0.20 * np.clip(depth, 0, None)
    u = u + 0.07 * np.clip(depth, 0, None)
    size = (np.abs(u / (2.08 * shrink)) ** 2.8 + np.abs(v / (1.80 * shrink)) ** 2.8) ** (1 / 2.8)
    return size, depth, shrink


def orbit(q):
    size, depth, shrink = orbit_frame(q)
    return clip((size - 1.0) * 1.6 * shrink, depth - 6.0, 0.8)


def nasal_opening(p):
    """The pear-shaped aperture: an inverted heart, running back."""
    x = smooth_abs(p[:, 0], 0.02)
    y = p[:, 1]
    low = np.hypot(x - 0.58, (y + 1.45) / 1.05) - 0.74
    high = np.hypot(x / 0.82, (y + 0.6) / 1.6) - 1.0
    flat = join(low, high * 0.62, 0.55)
    depth = 9.6 - p[:, 2]
    return clip(flat + 0.14 * np.clip(depth, 0, 4), depth - 3.6, 0.7)


def face(p):
    """Upper jaw, cheek bones, brows and nose, before anything is cut away."""
    q = mirrored(p, 0.12)
    core = join(ellipsoid(q, (0.0, 0.3, 5.2), (3.9, 4.0, 3.4)), ellipsoid(q, (4.05, 1.7, 5.0), (1.35, 2.5, 1.6)), 0.8)
    maxilla = ellipsoid(q, (1.55, -1.7, 6.6), (2.15, 2.6, 2.3))
    d = join(core, maxilla, 0.8)

    # alveolar process: a wall along the tooth row, with the roots showing
    s, across = UPPER_ROW.unfold(q[:, 0], q[:, 2])
    y = q[:, 1]
    roots, bays = np.zeros(len(p)), np.zeros(len(p))
    for centre, (kind, _, width, _) in zip(tooth_places(UPPER_TEETH), UPPER_TEETH):
        bays += 0.24 * bump(s, centre, 0.34 * width)
        tall = {"canine": 2.3, "incisor": 1.3}.get(kind, 1.1)
        high = {"canine": 0.26, "incisor": 0.15}.get(kind, 0.13)
        roots += high * bump(s, centre, 0.33 * width) * smoothstep(UPPER_GUM + tall, UPPER_GUM + 0.3, y)
    out = np.where(across > 0, across - roots, -across)
    wall = sdf.slab(np.maximum(UPPER_GUM - 0.12 + bays - y, y + 2.3), out - 0.66 + 0.08 * (y - UPPER_GUM), 0.24)
    wall = clip(wall, s - 6.35 - 0.25 * (y - UPPER_GUM), 0.9)
    d = join(d, wall, 0.8)

    # the medial rim of the orbit
    d = join(d, tube(q, [(0.7, 2.9, 8.8, 0.55), (1.15, 1.4, 8.75, 0.5), (1.45, 0.0, 8.7, 0.5), (1.75, -1.4, 8.6, 0.5),
                         (1.3, -2.6, 9.0, 0.45)], count=10), 0.5)
    # brow: glabella, arches, outer corners
    d = join(d, ellipsoid(q, (0.0, 3.9, 8.7), (1.6, 1.1, 1.25)), 0.8)
    d = join(d, tube(q, [(0.7, 3.5, 9.0, 0.62), (2.0, 4.0, 9.0, 0.62), (3.6, 4.0, 8.35, 0.55), (4.75, 3.4, 7.3, 0.5),
                         (5.25, 2.5, 6.5, 0.48)], count=12), 0.75)
    d = join(d, ellipsoid(q, (3.6, 3.95, 6.6), (1.5, 1.25, 1.5)), 0.8)
    # cheek bone: outer rim, body, lower rim, buttress to the molars
    rim = tube(q, [(5.25, 2.8, 6.6, 0.5), (5.3, 1.6, 6.2, 0.46), (5.25, 0.5, 6.35, 0.55), (4.9, -0.5, 6.85, 0.72),
                   (3.9, -0.75, 7.6, 0.62), (2.8, -0.6, 8.2, 0.5), (1.7, 0.0, 8.6, 0.4)], count=20)
    body = ellipsoid(q, (4.75, -1.0, 6.5), (1.15, 1.15, 1.0))
    buttress = tube(q, [(4.9, -1.2, 6.5, 0.7), (4.2, -2.3, 6.3, 0.6), (3.4, -3.2, 6.2, 0.6)], count=8)
    d = join(d, join_all([rim, body, buttress], 0.6), 0.6)
    return d


def nasal_bones(q):
    """The bridge: a roof that overhangs the top of the opening."""
    roof = tube(q, [(0.1, 3.2, 8.7, 0.75), (0.14, 2.3, 8.92, 0.6), (0.2, 1.65, 9.25, 0.5), (0.2, 1.15, 9.55, 0.38), (0.16, 0.9, 9.75, 0.28)], count=10)
    margin = tube(q, [(0.40, 1.35, 9.4, 0.36), (0.86, 0.45, 9.12, 0.34), (1.30, -0.6, 8.92, 0.33), (1.58, -1.5, 8.82, 0.32),
                      (1.25, -2.4, 8.98, 0.30)], count=12)
    roof = join(roof, margin, 0.4)
    under = tube(q, [(0.0, 1.0, 8.6, 0.42), (0.0, 0.45, 9.1, 0.42), (0.0, -0.1, 9.6, 0.5)], count=4)
    return carve(roof, under, 0.15)


def cheek_arch(q):
    """The zygomatic arch: a flat strap standing free of the temple."""
    strap = tube(q, [(5.0, -0.7, 6.5, 0.85), (5.85, -0.6, 5.6, 0.78), (6.42, -0.42, 4.3, 0.62), (6.66, -0.22, 3.0, 0.55),
                     (6.5, 0.02, 1.7, 0.58), (5.95, 0.25, 0.6, 0.62), (5.5, 0.5, -0.8, 0.5)], stretch=(1.9, 1.0, 1.0), count=18)
    return strap


def base(q):
    """What hangs below the brain case."""
    mastoid = join(capsule(q, (5.25, 0.1, -1.3), (5.0, -2.35, -0.5), 1.25, 0.66),
                   capsule(q, (5.0, 0.2, -2.4), (4.95, -1.2, -1.3), 1.0, 0.8), 0.6)
    crest = tube(q, [(5.8, 0.35, 0.6, 0.5), (5.85, 0.65, -0.8, 0.5), (5.6, 1.1, -2.4, 0.45), (5.0, 1.9, -4.2, 0.2)], stretch=(1.2, 1, 1), count=10)
    middle = rounded_box(q, (0, -0.8, 2.6), (2.4, 1.6, 3.6), 0.8)
    condyle = ellipsoid(q, (1.25, -2.35, -0.3), (0.55, 0.5, 1.1))
    wing = tube(q, [(1.7, -1.2, 3.6, 0.6), (1.8, -2.6, 3.7, 0.4), (1.9, -3.6, 3.9, 0.28)], stretch=(1.5, 1, 0.8), count=6)
    nuchal = tube(q, [(0, 0.5, -6.85, 0.5), (1.6, 0.8, -6.65, 0.45), (3.6, 0.6, -5.3, 0.42), (4.9, 0.1, -3.0, 0.5)], count=10)
    return join_all([join(mastoid, crest, 0.7), middle, condyle, wing, nuchal], 0.6)


def cranium(p):
    q = mirrored(p)
    soft = mirrored(p, 0.15)
    # temporal fossa: the hollow behind the outer rim of the orbit
    hollow = ellipsoid(q, (7.0, 1.2, 4.0), (2.35, 4.1, 2.5), sdf.turn("y", 12.0).T)
    case = carve(vault(p), hollow, 1.2)
    front = carve(face(p), ellipsoid(q, (6.95, 0.6, 3.9), (2.2, 3.6, 2.0), sdf.turn("y", 10.0).T), 0.5)
    front = carve(front, ellipsoid(q, (5.2, -3.4, 4.4), (1.75, 2.9, 1.9)), 0.5)
    d = join(case, front, 0.9)
    d = join(d, base(soft), 0.75)
    d = join(d, cheek_arch(q), 0.45)
    # canine fossa, ear, jaw joint, palate, great foramen
    d = carve(d, sphere(q, vec(3.35, -1.95, 8.75), 1.0), 0.7)
    d = carve(d, capsule(q, (5.2, 0.0, 0.05), (7.0, -0.1, 0.0), 0.33), 0.25)
    d = carve(d, ellipsoid(q, (5.0, -0.75, 1.4), (1.2, 0.75, 0.75)), 0.3)
    d = carve(d, ellipsoid(soft, (0, -4.3, 5.9), (2.35, 1.3, 3.0)), 0.5)
    d = carve(d, ellipsoid(soft, (0, -2.6, -2.0), (1.45, 1.6, 1.75)), 0.4)
    for hole, size in (((2.95, -1.15, 8.35), 0.2), ((2.15, 3.45, 9.15), 0.26), ((5.55, -0.6, 7.0), 0.12)):
        d = carve(d, sphere(q, vec(*hole), size), 0.2)
    # sockets and nose
    d = carve(d, orbit(q), 0.28)
    d = carve(d, nasal_opening(p), 0.2)
    d = join(d, nasal_bones(mirrored(p, 0.12)), 0.45)
    septum = sdf.slab(np.maximum(np.maximum(-2.5 - p[:, 1], p[:, 1] - 1.1), p[:, 2] - 7.9 + 0.12 * p[:, 1]),
                      np.abs(p[:, 0] - 0.06 * np.sin(p[:, 1] * 1.5)) - 0.11, 0.08)
    d = join(d, np.maximum(septum, 5.0 - p[:, 2]), 0.15)
    spine = capsule(soft, (0, -2.45, 9.0), (0, -2.3, 9.75), 0.32, 0.12)
    return join(d, spine, 0.35)


# --- lower jaw -------------------------------------------------------------

JAW_OUTLINE = sdf.closed_curve([
    (-2.0, -8.75), (0, -8.8), (1.5, -8.65), (3.0, -8.25), (5.0, -7.7), (6.5, -7.35), (7.8, -7.1), (8.75, -6.45),
    (9.15, -5.3), (9.15, -3.6), (9.35, -1.9), (9.55, -0.8), (9.2, -0.3), (8.75, -0.6), (8.5, -1.3), (7.75, -2.05),
    (7.0, -1.6), (6.55, -0.65), (6.2, -0.8), (6.05, -2.4), (5.7, -4.1), (5.2, -5.4), (4.5, -5.95), (3.0, -5.8),
    (1.5, -5.75), (0, -5.7), (-2.0, -5.7)], 4)


def jaw(p):
    q = mirrored(p, 0.1)
    y = q[:, 1]
    s, across = JAW_LINE.unfold(q[:, 0], q[:, 2])
    row = LOWER_ROW.unfold(q[:, 0], q[:, 2])[0]
    ramus = smoothstep(4.6, 7.0, s)
    # the tooth row leans in at the back, the angle flares out
    lean = 0.5 * smoothstep(-7.6, -5.6, y) * smoothstep(1.5, 4.5, s) * (1.0 - smoothstep(5.0, 6.5, s))
    flare = 0.28 * ramus * smoothstep(-5.0, -7.0, y)
    across = across + lean - flare
    half = 0.62 * (1 - ramus) + 0.30 * ramus
    half = half + 0.12 * bump(y, -8.2, 0.8) * (1 - ramus)
    roots, bays = np.zeros(len(p)), np.zeros(len(p))
    # the outline runs along the jaw, the teeth along their own, shorter row
    for centre, (kind, _, width, _) in zip(tooth_places(LOWER_TEETH), LOWER_TEETH):
        bays += 0.22 * bump(row, centre, 0.34 * width)
        tall = {"canine": 1.8}.get(kind, 1.1)
        high = {"canine": 0.2, "incisor": 0.12}.get(kind, 0.10)
        roots += high * bump(row, centre, 0.33 * width) * smoothstep(LOWER_GUM - tall, LOWER_GUM - 0.3, y)
    roots *= across > 0
    body = sdf.slab(np.maximum(sdf.outline(s, y, JAW_OUTLINE), np.where(s < 5.0, y - LOWER_GUM - 0.14 + bays, -1.0)), np.abs(across) - half - roots, 0.26)
    # condyles, chin, the oblique line
    d = join(body, ellipsoid(q, (4.95, -0.55, 1.35), (1.0, 0.48, 0.5), sdf.turn("y", 12.0).T), 0.45)
    d = join(d, capsule(q, (4.9, -0.9, 1.35), (4.85, -2.4, 1.6), 0.42, 0.3), 0.5)
    d = join(d, ellipsoid(q, (0, -8.2, 8.95), (1.0, 0.72, 0.62)), 0.7)
    d = join(d, ellipsoid(q, (1.25, -8.5, 8.65), (0.7, 0.5, 0.55)), 0.6)
    d = join(d, tube(q, [(4.05, -3.6, 4.6, 0.25), (4.05, -5.2, 4.9, 0.3), (3.75, -6.3, 5.3, 0.28), (3.2, -7.0, 6.3, 0.2)], count=8), 0.5)
    d = carve(d, ellipsoid(q, (0, -7.0, 9.9), (2.2, 0.75, 0.78)), 0.6)
    d = carve(d, sphere(q, vec(2.95, -7.2, 7.55), 0.22), 0.18)
    return d


# --- teeth -----------------------------------------------------------------

def tooth_places(row, start=-0.02, gap=0.0):
    """Arc lengths of the crowns' centres along the row."""
    s, out = start, []
    for _, _, width, _ in row:
        out.append(s + width / 2)
        s += width + gap
    return out


def tooth(p, kind, height, width, thick):
    """One tooth; x along the row, y from the biting edge to the root, z outward."""
    x, y, z = p.T
    t = np.clip(y / height, -0.3, 1.3)
    w = 0.5 * width * (1.0 - (0.16 if kind == "incisor" else 0.22) * smoothstep(0.3, 1.1, t))
    d = 0.5 * thick * (1.0 - 0.12 * smoothstep(0.6, 1.1, t))
    if kind in ("incisor", "canine"):
        edge = 0.24 if kind == "incisor" else 0.42
        d = d * (edge + (1.0 - edge) * smoothstep(-0.1, 0.85, t))
        z = z - 0.10 * thick * np.sin(np.pi * np.clip(t, 0, 1)) + 0.03
    else:
        w = w * (0.93 + 0.07 * smoothstep(0.0, 0.35, t))
        d = d * (0.80 + 0.20 * smoothstep(0.0, 0.5, t))
    u, k = x / w, z / d
    n = {"molar": 3.4, "incisor": 3.0}.get(kind, 2.6)
    side = ((np.abs(u) ** n + np.abs(k) ** n + 1e-9) ** (1 / n) - 1.0) * np.minimum(w, d)
    if kind == "incisor":
        top = 0.05 * u * u
    elif kind == "canine":
        top = 0.34 * (np.sqrt(u * u + 0.05) - 0.22)
    elif kind == "premolar":
        top = 0.20 * bump(k, -0.05, 0.30) + 0.16 * u * u + 0.08 * smoothstep(0.2, -0.6, k)
    else:
        top = 0.15 * bump(k, 0.0, 0.26) + 0.10 * bump(u, 0.05, 0.20) + 0.05 * u * u
    crown = clip(side, top - y, 0.09 if kind == "incisor" else 0.13)
    crown = clip(crown, y - height * 1.12, 0.25)
    root = capsule(p, (0, height * 0.85, 0), (0, height + 0.7, -0.05), 0.36 * min(width, thick), 0.2 * min(width, thick))
    if kind == "molar":
        root = rounded_box(p, (0, height + 0.1, 0), (0.38 * width, 0.6, 0.38 * thick), 0.25)
    return join(crown, root, 0.12)


def tooth_row(row, arch, gum, up, h):
    """Both halves of a row; `up` is +1 for upper teeth (roots upward)."""
    out = []
    for centre, (kind, height, width, thick) in zip(tooth_places(row), row):
        size = max(width, thick)
        mesh = sculpt(lambda p: tooth(p, kind, height, width, thick), (-size, -0.35, -size), (size, height + 1.2, size),
                      h, faces=700 if kind == "molar" else 560, rounds=2)
        (x, z), outward = arch.at(centre)
        side = vec(outward[1], 0, -outward[0])
        lean = {"incisor": 9.0, "canine": 5.0}.get(kind, 2.0) * (1 if up > 0 else 0.8)
        tilt = sdf.turn("x", lean if up > 0 else -lean)
        rows = np.stack([side, vec(0, up, 0), vec(outward[0], 0, outward[1])], axis=1) @ tilt
        origin = vec(x, gum - up * height * 0.93, z)
        pivot = vec(0, height, 0)
        placed = mesh.mapped(rows, origin + vec(0, up * height, 0) - rows @ pivot)
        out += [placed, placed.mapped(np.diag([-1.0, 1.0, 1.0]))]
    return merged(out)


# --- the whole -------------------------------------------------------------

def opened(mesh):
    turn = sdf.turn("x", JAW_OPEN)
    return mesh.mapped(turn, JAW_PIVOT - turn @ JAW_PIVOT)


def build(quality=1.0):
    """Named parts; `quality` < 1 is coarser, for looking at quickly."""
    h = 0.115 / quality
    k = min(1.0, quality ** 2)
    parts = [
        ("cranium", sculpt(cranium, (-8.2, -5.2, -10.2), (8.2, 13.2, 11.8), h, faces=int(46000 * k))),
        ("jaw", opened(sculpt(jaw, (-6.6, -10.0, -0.5), (6.6, 0.6, 10.6), h * 0.85, faces=int(17000 * k)))),
        ("upper teeth", tooth_row(UPPER_TEETH, UPPER_ROW, UPPER_GUM, 1, 0.06)),
        ("lower teeth", opened(tooth_row(LOWER_TEETH, LOWER_ROW, LOWER_GUM, -1, 0.06))),
    ]
    lo = np.min([m.vertices.min(axis=0) for _, m in parts], axis=0)
    hi = np.max([m.vertices.max(axis=0) for _, m in parts], axis=0)
    scale = 2.0 / (hi[1] - lo[1])
    return [(name, m.moved(scale, -scale * (lo + hi) / 2)) for name, m in parts]
