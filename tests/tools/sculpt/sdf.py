# SPDX-License-Identifier: GPL-3.0-or-later
"""Signed distance primitives and the soft operations that join them.

Every primitive takes points as an (N, 3) array and returns N distances,
negative inside, in the unit of the points. Most are bounds, not exact
distances; the polygoniser only needs the zero set and a sane slope near it.
"""

import numpy as np


def vec(*values):
    return np.array(values, dtype=float)


def length(q):
    return np.sqrt(np.einsum("ij,ij->i", q, q))


def unit(v):
    v = np.asarray(v, dtype=float)
    return v / np.linalg.norm(v)


def smooth_abs(x, eps):
    """|x| with its corner rounded over about `eps`: mirrors without a crease."""
    return np.sqrt(x * x + eps * eps)


def smoothstep(lo, hi, x):
    t = np.clip((x - lo) / (hi - lo), 0.0, 1.0)
    return t * t * (3.0 - 2.0 * t)


def bump(x, centre, width):
    """A soft hill of height 1 at `centre`, a Gaussian of that half width."""
    return np.exp(-(((x - centre) / width) ** 2))


def mirrored(p, eps=0.0):
    """The points folded onto x > 0."""
    q = p.copy()
    q[:, 0] = smooth_abs(p[:, 0], eps) if eps else np.abs(p[:, 0])
    return q


# --- combination -----------------------------------------------------------

def join(a, b, k):
    """Union with a fillet of size `k` (quadratic smooth minimum)."""
    if np.ndim(k) == 0 and k <= 0.0:
        return np.minimum(a, b)
    h = np.maximum(k - np.abs(a - b), 0.0) / k
    return np.minimum(a, b) - h * h * k * 0.25


def join_all(parts, k):
    out = parts[0]
    for part in parts[1:]:
        out = join(out, part, k)
    return out


def carve(a, b, k):
    """`a` without `b`, the new edge rounded over `k`."""
    return -join(-a, b, k)


def clip(a, b, k):
    """What lies in both, the edge rounded over `k`."""
    return -join(-a, -b, k)


# --- primitives ------------------------------------------------------------

def sphere(p, centre, radius):
    return length(p - centre) - radius


def frame(forward, up=(0.0, 1.0, 0.0)):
    """Rows: right, up, forward, with forward kept exactly."""
    w = unit(forward)
    u = unit(np.cross(up, w))
    return np.stack([u, np.cross(w, u), w])


def turn(axis, degrees):
    """Rotation matrix about 'x', 'y' or 'z'; use as p @ turn(...).T."""
    a = np.radians(degrees)
    c, s = np.cos(a), np.sin(a)
    return {"x": np.array([[1, 0, 0], [0, c, -s], [0, s, c]]),
            "y": np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]),
            "z": np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])}[axis]


def ellipsoid(p, centre, radii, rows=None):
    """`rows`: the ellipsoid's axes as the rows of a rotation matrix."""
    q = p - np.asarray(centre, dtype=float)
    if rows is not None:
        q = q @ np.asarray(rows).T
    q = q / np.asarray(radii, dtype=float)
    k0 = length(q)
    k1 = length(q / np.asarray(radii, dtype=float))
    return k0 * (k0 - 1.0) / np.maximum(k1, 1e-9)


def rounded_box(p, centre, half, radius, rows=None):
    q = p - np.asarray(centre, dtype=float)
    if rows is not None:
        q = q @ np.asarray(rows).T
    q = np.abs(q) - (np.asarray(half, dtype=float) - radius)
    outside = length(np.maximum(q, 0.0))
    return outside + np.minimum(q.max(axis=1), 0.0) - radius


def capsule(p, a, b, ra, rb=None):
    """A rod from a to b with radius ra at a and rb at b."""
    rb = ra if rb is None else rb
    a = np.asarray(a, dtype=float)
    b = np.asarray(b, dtype=float)
    ab = b - a
    q = p - a
    t = np.clip(q @ ab / (ab @ ab), 0.0, 1.0)
    q -= t[:, None] * ab
    return length(q) - (ra + t * (rb - ra))


def resample(points, count):
    """A Catmull-Rom curve through `points`, as `count` points, any columns."""
    pts = np.asarray(points, dtype=float)
    ext = np.vstack([2 * pts[0] - pts[1], pts, 2 * pts[-1] - pts[-2]])
    u = np.linspace(0.0, len(pts) - 1.0, count)
    i = np.minimum(u.astype(int), len(pts) - 2)
    t = (u - i)[:, None]
    a, b, c, d = ext[i], ext[i + 1], ext[i + 2], ext[i + 3]
    return 0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t ** 2
                  + (3 * b - a - 3 * c + d) * t ** 3)


def tube(p, path, stretch=(1.0, 1.0, 1.0), count=16):
    """A rod along a curve; `path` rows are x, y, z, radius.

    `stretch` > 1 along an axis flattens the section along it.
    """
    rows = resample(path, count) if count else np.asarray(path, dtype=float)
    s = np.asarray(stretch, dtype=float)
    best = np.full(len(p), np.inf)
    q = p * s
    for a, b in zip(rows[:-1], rows[1:]):
        best = np.minimum(best, capsule(q, a[:3] * s, b[:3] * s, a[3], b[3]))
    return best / s.max()


# --- flat outlines ---------------------------------------------------------

def outline(x, y, polygon):
    """Signed distance of points (x, y) to a closed polygon of (M, 2) corners."""
    poly = np.asarray(polygon, dtype=float)
    best = np.full(x.shape, np.inf)
    inside = np.zeros(x.shape, dtype=bool)
    for (ax, ay), (bx, by) in zip(np.roll(poly, 1, axis=0), poly):
        ex, ey = bx - ax, by - ay
        wx, wy = x - ax, y - ay
        t = np.clip((wx * ex + wy * ey) / max(ex * ex + ey * ey, 1e-18), 0.0, 1.0)
        best = np.minimum(best, (wx - ex * t) ** 2 + (wy - ey * t) ** 2)
        crosses = (ay > y) != (by > y)
        if ey != 0.0:
            inside ^= crosses & (wx < ex * wy / ey)
    d = np.sqrt(best)
    return np.where(inside, -d, d)


def closed_curve(points, per_segment=6):
    """A smooth closed polygon through `points`."""
    pts = np.asarray(points, dtype=float)
    n = len(pts)
    ring = np.vstack([pts[-1:], pts, pts[:2]])
    out = []
    for i in range(n):
        a, b, c, d = ring[i], ring[i + 1], ring[i + 2], ring[(i + 3)]
        t = np.arange(per_segment)[:, None] / per_segment
        out.append(0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t ** 2
                          + (3 * b - a - 3 * c + d) * t ** 3))
    return np.vstack(out)


def slab(d2, d1, radius):
    """An outline (d2) given a thickness (d1), its edges rounded by `radius`."""
    a, b = d2 + radius, d1 + radius
    return (np.hypot(np.maximum(a, 0.0), np.maximum(b, 0.0))
            + np.minimum(np.maximum(a, b), 0.0) - radius)


class Arch:
    """A curve in the ground plane, mirrored in x, that shapes are bent along.

    `points` are (x, z), from the front (x = 0) to the back; `unfold` gives for
    every point the arc length from the front, and the distance across the
    curve, positive outward.
    """

    def __init__(self, points, count=48):
        fine = resample(points, 400)
        length = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(fine, axis=0), axis=1))])
        s = np.linspace(0.0, length[-1], count)
        self.length = length[-1]
        self.s = s
        self.xy = np.stack([np.interp(s, length, fine[:, k]) for k in (0, 1)], axis=1)

    def at(self, s):
        """Position (x, z) and outward direction at arc length s."""
        e = 1e-3 * self.length
        pos = vec(np.interp(s, self.s, self.xy[:, 0]), np.interp(s, self.s, self.xy[:, 1]))
        a = np.array([np.interp(s + o, self.s, self.xy[:, k]) for o in (-20 * e, 20 * e) for k in (0, 1)])
        t = unit(a[2:] - a[:2])
        return pos, vec(-t[1], t[0])

    def unfold(self, x, z):
        pts, s = self.xy, self.s
        best = np.full(x.shape, np.inf)
        arc = np.zeros(x.shape)
        across = np.zeros(x.shape)
        last = len(pts) - 2
        for i in range(len(pts) - 1):
            (ax, az), (bx, bz) = pts[i], pts[i + 1]
            ex, ez = bx - ax, bz - az
            ll = np.hypot(ex, ez)
            t = ((x - ax) * ex + (z - az) * ez) / (ll * ll)
            t = np.clip(t, 0.0, np.inf if i == last else 1.0)  # the curve runs on straight past its end
            dx, dz = x - ax - ex * t, z - az - ez * t
            d = np.hypot(dx, dz)
            near = d < best
            best = np.where(near, d, best)
            arc = np.where(near, s[i] + t * ll, arc)
            side = -ez * (x - ax) + ex * (z - az)
            across = np.where(near, np.where(side >= 0.0, d, -d), across)
        return arc, across
