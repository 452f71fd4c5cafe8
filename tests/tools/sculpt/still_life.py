# SPDX-License-Identifier: GPL-3.0-or-later
"""A kitchen table still life: jug, bottle, bowl of fruit, pear, apple, cloth.

Decimetres, y up, the table top at y = 0, seen from +z.
"""

import numpy as np
from skimage.measure import find_contours

from . import sdf
from .polygonise import Mesh, face_cross, sculpt
from .sdf import bump, carve, clip, closed_curve, ellipsoid, join, smoothstep, tube, vec

TABLE_RADIUS, TABLE_THICKNESS = 3.6, 0.32


def turned(p, profile, x=None, z=None):
    """A solid of revolution about y; `profile` is a closed outline of (r, y)."""
    r = np.hypot(p[:, 0] if x is None else x, p[:, 2] if z is None else z)
    return sdf.outline(r, p[:, 1], profile)


def spun(points, per_segment=12):
    """A smooth outline from half a profile, mirrored over the axis."""
    half = np.asarray(points, dtype=float)
    other = half[::-1] * (-1.0, 1.0)
    return closed_curve(np.vstack([half, other]), per_segment)


# --- things ----------------------------------------------------------------

def lathe(profile, segments):
    """A mesh turned about y; `profile` rows are (r, y, nr, ny), from the axis above to the axis below."""
    prof = np.asarray(profile, dtype=float)
    ring, n = prof[1:-1], segments
    angle = 2 * np.pi * np.arange(n) / n
    turn = np.stack([np.sin(angle), np.cos(angle)], axis=1)

    def swept(r, y):
        return np.stack([np.outer(r, turn[:, 0]), np.repeat(y[:, None], n, axis=1), np.outer(r, turn[:, 1])], -1).reshape(-1, 3)

    v = np.vstack([swept(ring[:, 0], ring[:, 1]), [0, prof[0, 1], 0], [0, prof[-1, 1], 0]])
    normals = np.vstack([swept(ring[:, 2], ring[:, 3]), [0, 1, 0], [0, -1, 0]])
    m = len(ring)
    here, there = np.arange(n), (np.arange(n) + 1) % n
    f = [np.stack([np.full(n, m * n), here, there], 1),
         np.stack([np.full(n, m * n + 1), (m - 1) * n + there, (m - 1) * n + here], 1)]
    for i in range(m - 1):
        p, q = i * n + here, i * n + there
        f += [np.stack([p, p + n, q], 1), np.stack([q, p + n, q + n], 1)]
    return Mesh(v, np.vstack(f), normals)


def turned_mesh(field, radius, low, high, rows, segments, h=0.012):
    """A round thing as a lathe mesh; its profile is read off `field`, rows closer where it bends."""
    def at(r, y):
        return field(np.stack([r, y, np.zeros_like(r)], axis=1))

    def slope(r, y, e=2e-3):
        g = np.stack([at(r + e, y) - at(r - e, y), at(r, y + e) - at(r, y - e)], axis=1)
        return g / np.linalg.norm(g, axis=1)[:, None]

    rs, ys = np.arange(0.0, radius, h), np.arange(low, high, h)
    grid = at(*(x.ravel() for x in np.meshgrid(rs, ys, indexing="ij"))).reshape(len(rs), len(ys))
    line = max(find_contours(grid, 0.0), key=len) * h + (0.0, low)
    if line[0, 1] < line[-1, 1]:
        line = line[::-1]
    r, y = line[1:-1].T
    n = slope(r, y)
    for _ in range(3):
        n = slope(r, y)
        d = at(r, y)
        r, y = r - d * n[:, 0], y - d * n[:, 1]
    run = np.hypot(np.diff(r), np.diff(y))
    bend = np.arccos(np.clip((n[1:] * n[:-1]).sum(axis=1), -1, 1))
    pace = np.concatenate([[0], np.cumsum(run / run.sum() + 0.9 * bend / bend.sum())])
    pace /= pace[-1]
    t = np.linspace(0.004, 0.996, rows)
    r, y = np.interp(t, pace, r), np.interp(t, pace, y)
    for _ in range(2):
        n = slope(r, y)
        d = at(r, y)
        r, y = r - d * n[:, 0], y - d * n[:, 1]
    n = slope(r, y)
    body = np.stack([r, y, n[:, 0], n[:, 1]], axis=1)
    body = body[body[:, 0] > 0.03]
    return lathe([(0.0, line[0, 1], 0, 1), *body.tolist(), (0.0, line[-1, 1], 0, -1)], segments)


def table():
    """A round top with a bull-nosed edge."""
    half = TABLE_THICKNESS / 2
    t = np.linspace(np.pi / 2, -np.pi / 2, 17)
    edge = np.stack([TABLE_RADIUS - half + half * np.cos(t), half * np.sin(t) - half, np.cos(t), np.sin(t)], 1)
    rows = [(0.0, 0.0, 0, 1)] + [(r, 0.0, 0, 1) for r in (0.4, 1.2, 2.0, 2.8)] + edge.tolist()
    rows += [(r, -2 * half, 0, -1) for r in (2.4, 1.2, 0.4)] + [(0.0, -2 * half, 0, -1)]
    return lathe(rows, 108)


JUG_OUTSIDE = spun([(0.0, 0.0), (0.45, 0.0), (0.78, 0.02), (0.82, 0.12), (0.80, 0.2), (1.06, 0.62), (1.2, 1.1), (1.1, 1.6), (0.82, 2.1),
                    (0.66, 2.5), (0.68, 2.9), (0.82, 3.35), (0.5, 3.6), (0.0, 3.7)])
JUG_INSIDE = spun([(0.0, 0.25), (0.6, 0.27), (0.92, 0.62), (1.07, 1.1), (0.97, 1.6), (0.70, 2.1), (0.54, 2.5), (0.56, 2.9),
                   (0.70, 3.35), (0.78, 3.8), (0.5, 4.2), (0.0, 4.3)])


def jug(p):
    x, y, z = p.T
    # the lip is drawn out to a beak at +x
    lift = smoothstep(2.45, 3.3, y)
    beak = lift * smoothstep(0.15, 0.95, x)
    xs = x - 0.42 * beak
    zs = z * (1.0 + 0.75 * beak)
    ys = y - 0.20 * beak
    q = np.stack([xs, ys, zs], axis=1)
    outside = turned(q, JUG_OUTSIDE) * 0.8
    inside = turned(q, JUG_INSIDE) * 0.8
    rim = ys - 3.28
    ring = np.hypot(np.hypot(xs, zs) - 0.80, ys - 3.25) - 0.075
    foot = np.hypot(np.hypot(x, z) - 0.83, y - 0.12) - 0.10
    band = np.hypot(np.hypot(x, z) - 0.72, y - 2.3) - 0.06
    body = join(clip(outside, rim, 0.06), ring * 0.8, 0.10)
    body = join(join(body, foot, 0.06), band, 0.07)
    grip = tube(p, [(-0.62, 3.0, 0, 0.13), (-0.95, 3.22, 0, 0.13), (-1.45, 3.0, 0, 0.125), (-1.65, 2.4, 0, 0.115),
                    (-1.5, 1.75, 0, 0.11), (-1.1, 1.38, 0, 0.15)], stretch=(1.0, 1.0, 0.72), count=26)
    thumb = ellipsoid(p, (-1.05, 3.26, 0), (0.16, 0.12, 0.13))
    body = join(join(body, grip, 0.14), thumb, 0.12)
    return carve(body, inside, 0.05)


BOTTLE = spun([(0.0, 0.10), (0.4, 0.06), (0.56, 0.0), (0.63, 0.08), (0.645, 0.3), (0.645, 1.2), (0.64, 2.0), (0.60, 2.4), (0.42, 2.78),
               (0.25, 3.05), (0.205, 3.4), (0.195, 3.95), (0.19, 4.1), (0.0, 4.12)])


def bottle(p):
    r = np.hypot(p[:, 0], p[:, 2])
    d = turned(p, BOTTLE)
    lip = np.hypot(np.maximum(r - 0.2, 0) * 1.0, np.maximum(np.abs(p[:, 1] - 3.92) - 0.06, 0)) - 0.065
    d = join(d, lip, 0.03)
    cork = sdf.slab(r - 0.155, np.abs(p[:, 1] - 4.18) - 0.17, 0.05)
    return join(d, cork, 0.025)


BOWL_OUTSIDE = spun([(0.0, 0.04), (0.35, 0.05), (0.52, 0.0), (0.60, 0.04), (0.60, 0.14), (0.95, 0.36), (1.25, 0.68), (1.40, 1.05),
                     (1.2, 1.4), (0.0, 1.6)])
BOWL_INSIDE = spun([(0.0, 0.22), (0.5, 0.26), (0.90, 0.48), (1.15, 0.74), (1.29, 1.05), (1.36, 1.4), (1.0, 1.8), (0.0, 1.9)])


def bowl(p):
    r = np.hypot(p[:, 0], p[:, 2])
    d = clip(turned(p, BOWL_OUTSIDE), p[:, 1] - 1.02, 0.05)
    d = join(d, np.hypot(r - 1.35, p[:, 1] - 1.0) - 0.08, 0.06)
    d = join(d, np.hypot(r - 1.235, p[:, 1] - 0.66) - 0.05, 0.09)
    return carve(d, turned(p, BOWL_INSIDE), 0.05)


APPLE = spun([(0.0, 0.12), (0.10, 0.09), (0.24, 0.0), (0.45, 0.10), (0.63, 0.38), (0.70, 0.68), (0.64, 0.98), (0.44, 1.16), (0.24, 1.17),
              (0.10, 1.06), (0.0, 0.96)])


def apple(p):
    phi = np.arctan2(p[:, 2], p[:, 0])
    lobes = 1.0 + (0.035 * smoothstep(0.7, 0.0, p[:, 1]) + 0.015) * np.cos(5 * phi + 0.4)
    d = turned(p, APPLE, p[:, 0] / lobes, p[:, 2] / lobes)
    return join(d, tube(p, [(0, 0.95, 0, 0.035), (0.02, 1.2, 0.01, 0.033), (0.12, 1.42, 0.03, 0.05)], count=8), 0.06)


PEAR = spun([(0.0, 0.10), (0.10, 0.07), (0.26, 0.0), (0.52, 0.10), (0.72, 0.42), (0.74, 0.78), (0.58, 1.16), (0.40, 1.50), (0.32, 1.82),
             (0.22, 2.02), (0.08, 2.06), (0.0, 2.01)])


def pear(p):
    q = p.copy()
    q[:, 0] -= 0.10 * smoothstep(0.6, 2.2, p[:, 1]) + 0.02 * np.sin(2 * p[:, 1])
    q[:, 2] += 0.05 * smoothstep(0.8, 2.2, p[:, 1])
    phi = np.arctan2(q[:, 2], q[:, 0])
    swell = 1.0 + 0.03 * np.cos(phi - 0.8) * bump(p[:, 1], 0.6, 0.7) + 0.012 * np.cos(3 * phi)
    d = turned(q, PEAR, q[:, 0] / swell, q[:, 2] / swell)
    return join(d, tube(p, [(0.1, 1.95, -0.05, 0.05), (0.13, 2.2, -0.05, 0.042), (0.26, 2.5, -0.02, 0.055)], count=10), 0.07)


def lemon(p):
    """Lies along x."""
    d = ellipsoid(p, (0, 0, 0), (0.66, 0.50, 0.50))
    d = join(d, ellipsoid(p, (0.66, 0.02, 0), (0.16, 0.12, 0.12)), 0.16)
    return join(d, ellipsoid(p, (-0.63, 0, 0), (0.10, 0.13, 0.13)), 0.14)


# --- cloth -----------------------------------------------------------------

def cloth_surface(u, v):
    """Middle of the cloth: u in [-1, 1] across, v in [0, 1] from the table to the hem."""
    start, drop = 1.15, 2.7
    bend = 0.30                                   # radius over the table's edge
    edge = TABLE_RADIUS - bend + 0.05
    flat_run = edge - start
    arc = bend * np.pi / 2
    hang = drop * (1.0 - 0.42 * np.abs(u) ** 1.5) - 0.3
    run = v * (flat_run + arc + hang)
    on_top = np.minimum(run, flat_run)
    over = np.clip(run - flat_run, 0.0, arc) / bend
    down = np.maximum(run - flat_run - arc, 0.0)
    wide = 0.42 + 0.07 * smoothstep(0.0, 3.0, run)
    phi = u * wide + 0.05 * np.sin(2.4 * v + 0.6) * (1 - u * u)
    rho = start + on_top + bend * np.sin(over)
    y = 0.06 - bend * (1.0 - np.cos(over)) - down
    # pleats: gathered ridges on the table that open into hanging folds
    fan = phi / 0.46
    wave = (0.55 * np.cos(8.3 * fan + 0.9 * np.sin(1.9 * v)) + 0.30 * np.cos(13.0 * fan + 1.3 + 0.8 * v)
            + 0.25 * np.cos(4.1 * fan - 0.7))
    wave = 0.5 + 0.5 * np.tanh(1.2 * wave)
    lying = 0.24 * smoothstep(0.2, 2.8, run) * (1.0 - 0.45 * smoothstep(flat_run * 0.55, flat_run, run))
    falling = 0.11 + 0.46 * smoothstep(0.0, 1.9, down)
    ridge = 0.10 * np.exp(-((fan + 0.35 - 0.6 * v) / 0.14) ** 2) + 0.07 * np.exp(-((fan - 0.5 + 0.3 * v) / 0.12) ** 2)
    mix = over / (np.pi / 2)
    lift = (lying * wave + ridge) * (1.0 - mix) + falling * wave * mix
    rho = rho + lift * np.sin(over)
    y = y + lift * np.cos(over)
    turn = phi + 0.05 * np.sin(6.0 * fan + 1.0) * smoothstep(0.0, 2.0, down)
    return np.stack([rho * np.sin(turn), y, rho * np.cos(turn)], axis=-1)


def pillow(surface, nu, nv, thick, hem):
    """A closed sheet of half thickness `thick` about a surface patch.

    Thickness rounds off to nothing over the outermost `hem` of the parameters.
    """
    def spread(n):
        t = np.linspace(0.0, 1.0, n)
        rim = hem * np.array([0.0, 0.08, 0.3, 0.62])
        return np.concatenate([rim, hem + (1 - 2 * hem) * t[1:-1], 1 - rim[::-1]])

    a, b = spread(nu), spread(nv)
    U, V = np.meshgrid(2 * a - 1, b, indexing="ij")
    e = 1e-4
    mid = surface(U, V)
    normal = np.cross(surface(U, V + e) - surface(U, V - e), surface(U + e, V) - surface(U - e, V))
    normal /= np.linalg.norm(normal, axis=-1)[..., None]
    gap = np.minimum(np.minimum(*np.meshgrid(a, b, indexing="ij")),
                     np.minimum(*np.meshgrid(1 - a, 1 - b, indexing="ij"))) / hem
    t = thick * np.sqrt(np.clip(1.0 - (1.0 - np.clip(gap, 0, 1)) ** 2, 0, 1))
    top, bottom = mid + normal * t[..., None], mid - normal * t[..., None]
    m, n = U.shape
    index = np.arange(m * n).reshape(m, n)
    rim = np.ones((m, n), dtype=bool)
    rim[1:-1, 1:-1] = False
    under = np.where(rim, index, 0)
    under[~rim] = m * n + np.arange((~rim).sum())
    v = np.vstack([top.reshape(-1, 3), bottom[~rim]])

    def quads(g):
        p, q, r, s = (x.ravel() for x in (g[:-1, :-1], g[1:, :-1], g[1:, 1:], g[:-1, 1:]))
        one, two = np.stack([p, r, q], -1), np.stack([p, s, r], -1)
        # the diagonal of a corner quad must start at the corner
        for i in ((m - 2) * (n - 1), n - 2):
            one[i], two[i] = (p[i], s[i], q[i]), (q[i], s[i], r[i])
        return np.vstack([one, two])

    f = np.vstack([quads(index), quads(under)[:, ::-1]])
    cross = face_cross(v, f)
    normals = np.zeros_like(v)
    for k in range(3):
        np.add.at(normals, f[:, k], cross)
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    return Mesh(v, f, normals)


# --- the arrangement -------------------------------------------------------

def build(quality=1.0):
    """Named parts, scaled to about 2.4 units across, centred."""
    def make(name, field, lo, hi, h, faces, at, turn=None):
        mesh = sculpt(field, lo, hi, h / quality, faces=int(faces * min(1, quality ** 2)))
        return name, mesh.mapped(np.eye(3) if turn is None else turn, np.asarray(at, dtype=float))

    spin, still = sdf.turn, np.eye(3)
    parts = [
        ("table", table()),
        make("jug", jug, (-2.1, -0.25, -1.5), (1.7, 3.9, 1.5), 0.045, 10000, (-1.65, 0.0, -0.75), spin("y", 205)),
        ("bottle", turned_mesh(bottle, 0.9, -0.2, 4.6, int(56 * quality), 64).mapped(still, vec(0.35, 0.0, -1.75))),
        ("bowl", turned_mesh(bowl, 1.7, -0.2, 1.4, int(64 * quality), 72).mapped(still, vec(1.85, 0.0, -0.15))),
        make("apple", apple, (-0.95, -0.2, -0.95), (0.95, 1.7, 0.95), 0.04, 4000, (2.15, 0.48, -0.3), spin("z", -22) @ spin("y", 40)),
        make("lemon", lemon, (-1.1, -0.8, -0.8), (1.1, 0.8, 0.8), 0.04, 2600, (1.2, 1.35, 0.1), spin("y", 55) @ spin("z", 18)),
        make("pear", pear, (-1.05, -0.2, -1.05), (1.05, 2.8, 1.05), 0.04, 4400, (-0.35, 0.0, 0.75), spin("y", -20)),
        make("windfall", apple, (-0.95, -0.2, -0.95), (0.95, 1.7, 0.95), 0.04, 4000, (0.75, 0.566, 1.6),
             spin("y", -35) @ spin("z", -78)),
    ]
    sheet = pillow(cloth_surface, int(60 * quality), int(48 * quality), 0.035, 0.02)
    parts.append(("cloth", sheet.mapped(spin("y", -24))))
    lo = np.min([m.vertices.min(axis=0) for _, m in parts], axis=0)
    hi = np.max([m.vertices.max(axis=0) for _, m in parts], axis=0)
    scale = 2.4 / (hi - lo).max()
    return [(name, m.moved(scale, -scale * (lo + hi) / 2)) for name, m in parts]
