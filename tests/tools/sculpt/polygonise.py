# SPDX-License-Identifier: GPL-3.0-or-later
"""From a distance field to a clean closed triangle mesh.

Marching cubes on a narrow band, quadric decimation in batches of independent
edge collapses, then tangential relaxation and Newton steps that put every
vertex back on the surface. Normals are the field's gradient.
"""

from dataclasses import dataclass

import numpy as np
from scipy import sparse
from scipy.sparse.csgraph import connected_components
from skimage.measure import marching_cubes


@dataclass
class Mesh:
    """Vertices (N, 3), faces (M, 3) wound outward, unit normals (N, 3)."""
    vertices: np.ndarray
    faces: np.ndarray
    normals: np.ndarray

    def moved(self, scale, offset):
        """Scaled uniformly, then translated."""
        return Mesh(self.vertices * scale + offset, self.faces, self.normals)

    def mapped(self, matrix, offset=0.0):
        """Under a rotation or a reflection (which also turns the winding)."""
        faces = self.faces if np.linalg.det(matrix) > 0 else self.faces[:, ::-1]
        return Mesh(self.vertices @ matrix.T + offset, faces.copy(), self.normals @ matrix.T)


def merged(meshes):
    offsets = np.cumsum([0] + [len(m.vertices) for m in meshes[:-1]])
    return Mesh(np.vstack([m.vertices for m in meshes]),
                np.vstack([m.faces + o for m, o in zip(meshes, offsets)]),
                np.vstack([m.normals for m in meshes]))


def evaluate(field, points, chunk=200_000):
    return np.concatenate([field(points[i:i + chunk]) for i in range(0, len(points), chunk)])


_TETRA = np.array([[1, -1, -1], [-1, -1, 1], [-1, 1, -1], [1, 1, 1]], dtype=float)


def gradient(field, points, eps):
    g = np.zeros_like(points)
    for corner in _TETRA:
        g += corner * evaluate(field, points + corner * eps)[:, None]
    return g / (4.0 * eps)


def project(field, points, reach, steps=3):
    """Newton steps along the gradient, none longer than `reach`."""
    p = points.copy()
    for _ in range(steps):
        d = evaluate(field, p)
        g = gradient(field, p, reach * 0.05)
        step = d / np.maximum((g * g).sum(axis=1), 0.04)
        length = np.abs(step) * np.linalg.norm(g, axis=1)
        step *= np.minimum(1.0, reach / np.maximum(length, 1e-12))
        p -= g * step[:, None]
    return p


def sample_band(field, lo, hi, h, slack=1.6):
    """The field on a grid of spacing h: exact near the surface, rough elsewhere."""
    coarse = 4
    cells = np.ceil((np.asarray(hi) - lo) / (coarse * h)).astype(int)
    axes = [lo[k] + np.arange(cells[k] + 1) * coarse * h for k in range(3)]
    nodes = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
    rough = evaluate(field, nodes.reshape(-1, 3)).reshape(nodes.shape[:3])

    corner = [rough[i:i + cells[0], j:j + cells[1], k:k + cells[2]]
              for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    least = np.min([np.abs(c) for c in corner], axis=0)
    mixed = (np.min(corner, axis=0) < 0) != (np.max(corner, axis=0) < 0)
    active = mixed | (least < slack * coarse * h)

    fine = cells * coarse + 1
    index = [np.minimum((np.arange(n) + coarse // 2) // coarse, c) for n, c in zip(fine, cells)]
    grid = rough[np.ix_(*index)].astype(np.float64)
    want = np.zeros(tuple(fine), dtype=bool)
    for i in range(coarse + 1):
        for j in range(coarse + 1):
            for k in range(coarse + 1):
                want[i:i + cells[0] * coarse:coarse, j:j + cells[1] * coarse:coarse,
                     k:k + cells[2] * coarse:coarse][active] = True
    where = np.argwhere(want)
    grid[want] = evaluate(field, where * h + lo)
    # No vertex may sit on a grid node: marching cubes would make empty triangles.
    tiny = 0.02 * h
    grid[np.abs(grid) < tiny] = tiny
    return grid


def edge_list(faces):
    e = np.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    return np.unique(np.sort(e, axis=1), axis=0)


def face_cross(v, f):
    return np.cross(v[f[:, 1]] - v[f[:, 0]], v[f[:, 2]] - v[f[:, 0]])


def component_labels(count, faces):
    e = edge_list(faces)
    graph = sparse.coo_matrix((np.ones(len(e)), (e[:, 0], e[:, 1])), shape=(count, count))
    return connected_components(graph, directed=False)[1]


def volumes(v, f, labels):
    six = np.einsum("ij,ij->i", v[f[:, 0]], np.cross(v[f[:, 1]], v[f[:, 2]]))
    return np.bincount(labels[f[:, 0]], weights=six, minlength=labels.max() + 1) / 6.0


def compacted(v, f):
    used = np.unique(f)
    remap = np.full(len(v), -1)
    remap[used] = np.arange(len(used))
    return v[used], remap[f]


def biggest_part(v, f):
    labels = component_labels(len(v), f)
    vol = volumes(v, f, labels)
    keep = labels[f[:, 0]] == np.argmax(vol)
    return compacted(v, f[keep])


def _plane_quadrics(v, f):
    n = face_cross(v, f)
    area = np.linalg.norm(n, axis=1)
    n = n / np.maximum(area, 1e-30)[:, None]
    d = -np.einsum("ij,ij->i", n, v[f[:, 0]])
    q = np.concatenate([n, d[:, None]], axis=1)
    i, j = np.triu_indices(4)
    face_q = q[:, i] * q[:, j] * area[:, None]
    out = np.zeros((len(v), 10))
    for k in range(3):
        for c in range(10):
            out[:, c] += np.bincount(f[:, k], weights=face_q[:, c], minlength=len(v))
    return out


def _quadric_error(q, p):
    x, y, z = p.T
    return (q[:, 0] * x * x + 2 * q[:, 1] * x * y + 2 * q[:, 2] * x * z + 2 * q[:, 3] * x
            + q[:, 4] * y * y + 2 * q[:, 5] * y * z + 2 * q[:, 6] * y
            + q[:, 7] * z * z + 2 * q[:, 8] * z + q[:, 9])


def _longest2(v, f):
    tri = v[f]
    return np.max([((tri[:, i] - tri[:, i - 1]) ** 2).sum(axis=1) for i in range(3)], axis=0)


def _apart(order, a, b, adjacency, most):
    """The first edges of `order` of which no two touch the same face."""
    locked = np.zeros(adjacency.shape[0], dtype=bool)
    start, near = adjacency.indptr, adjacency.indices
    pick = []
    for edge, i, j in zip(order.tolist(), a[order].tolist(), b[order].tolist()):
        if not (locked[i] or locked[j]):
            pick.append(edge)
            locked[near[start[i]:start[i + 1]]] = True
            locked[near[start[j]:start[j + 1]]] = True
            if len(pick) >= most:
                break
    return np.array(pick, dtype=int)


def decimate(v, f, target, evenness=2e-3):
    """Collapse edges until about `target` faces are left; topology is kept.

    Each round takes the cheapest edges that share no faces. `evenness` weighs
    an edge's length against the shape it would lose.
    """
    v = v.copy()
    quadrics = _plane_quadrics(v, f)
    tired = np.zeros(len(v))  # grows where a collapse was refused
    for _ in range(200):
        if len(f) <= target:
            break
        n = len(v)
        e = edge_list(f)
        a, b = e.T
        adjacency = sparse.coo_matrix((np.ones(2 * len(e), dtype=np.int32),
                                       (np.r_[a, b], np.r_[b, a])), shape=(n, n)).tocsr()
        degree = np.diff(adjacency.indptr)
        shared = adjacency.multiply(adjacency @ adjacency).tocsr()
        common = np.asarray(shared[a, b]).ravel()
        middle = 0.5 * (v[a] + v[b])
        length2 = ((v[a] - v[b]) ** 2).sum(axis=1)
        cost = np.maximum(_quadric_error(quadrics[a] + quadrics[b], middle), 0.0)
        cost += evenness * length2 * length2
        cost *= np.exp(np.minimum(tired[a], tired[b]))
        # The two vertices opposite the edge each lose a face; neither may run short.
        half = np.vstack([f[:, [0, 1]], f[:, [1, 2]], f[:, [2, 0]]])
        half.sort(axis=1)
        opposite = np.full(len(e), 99)
        np.minimum.at(opposite, np.searchsorted(a * n + b, half[:, 0] * n + half[:, 1]),
                      degree[np.r_[f[:, 2], f[:, 0], f[:, 1]]])
        merged_degree = degree[a] + degree[b] - 4
        bad = (common != 2) | (merged_degree > 9) | (merged_degree < 4) | (opposite < 5)
        cost[bad] = np.inf
        order = np.argsort(cost, kind="stable")
        order = order[:min(np.isfinite(cost).sum(), len(e) // 4 + 1)]
        pick = _apart(order, a, b, adjacency, (len(f) - target + 1) // 2)
        if not len(pick):
            break

        trial = v.copy()
        trial[a[pick]] = middle[pick]
        trial[b[pick]] = middle[pick]
        owner = np.full(n, -1)
        owner[a[pick]] = np.arange(len(pick))
        owner[b[pick]] = np.arange(len(pick))
        fo = owner[f]
        touched = fo.max(axis=1)
        gone = (fo >= 0).sum(axis=1) == 2
        check = np.flatnonzero((touched >= 0) & ~gone)
        before = face_cross(v, f[check])
        after = face_cross(trial, f[check])
        la, lb = np.linalg.norm(after, axis=1), np.linalg.norm(before, axis=1)
        turned = np.einsum("ij,ij->i", before, after) < 0.5 * la * lb
        fair_after, fair_before = la / _longest2(trial, f[check]), lb / _longest2(v, f[check])
        sliver = fair_after < np.minimum(0.15, 0.6 * fair_before)
        refuse = np.zeros(len(pick), dtype=bool)
        refuse[touched[check[turned | sliver]]] = True
        tired *= 0.9
        tired[np.r_[a[pick[refuse]], b[pick[refuse]]]] += 3.0
        pick = pick[~refuse]
        if not len(pick):
            continue
        v[a[pick]] = middle[pick]
        quadrics[a[pick]] += quadrics[b[pick]]
        remap = np.arange(n)
        remap[b[pick]] = a[pick]
        f = remap[f]
        f = f[(f[:, 0] != f[:, 1]) & (f[:, 1] != f[:, 2]) & (f[:, 2] != f[:, 0])]
        used = np.unique(f)
        pack = np.full(n, -1)
        pack[used] = np.arange(len(used))
        v, quadrics, tired, f = v[used], quadrics[used], tired[used], pack[f]
    return v, f


def relax(field, v, f, reach, rounds, strength=0.5):
    """Slide vertices along the surface towards their neighbours' mean."""
    e = edge_list(f)
    n = len(v)
    m = sparse.coo_matrix((np.ones(2 * len(e)), (np.r_[e[:, 0], e[:, 1]], np.r_[e[:, 1], e[:, 0]])),
                          shape=(n, n)).tocsr()
    degree = np.diff(m.indptr)[:, None]
    for _ in range(rounds):
        g = gradient(field, v, reach * 0.05)
        g /= np.maximum(np.linalg.norm(g, axis=1), 1e-12)[:, None]
        pull = (m @ v) / degree - v
        pull -= g * np.einsum("ij,ij->i", pull, g)[:, None]
        moved = project(field, v + strength * pull, reach, steps=1)
        # A vertex that would fold one of its faces stays where it was.
        for _ in range(4):
            old, new = face_cross(v, f), face_cross(moved, f)
            fold = np.einsum("ij,ij->i", old, new) < 0.3 * np.linalg.norm(old, axis=1) * np.linalg.norm(new, axis=1)
            if not fold.any():
                break
            held = np.unique(f[fold])
            moved[held] = v[held]
        v = moved
    return v


def sculpt(field, lo, hi, h, faces=None, rounds=2, normal_eps=None):
    """The zero set of `field` inside the box, sampled every `h`, as a Mesh."""
    lo = np.asarray(lo, dtype=float)
    grid = sample_band(field, lo, np.asarray(hi, dtype=float), h)
    shell = [grid[0], grid[-1], grid[:, 0], grid[:, -1], grid[:, :, 0], grid[:, :, -1]]
    if min(s.min() for s in shell) < 0:
        raise ValueError("the surface leaves its box")
    v, f, _, _ = marching_cubes(grid.astype(np.float32), 0.0, method="lewiner")
    v = v.astype(float) * h + lo
    f = f.astype(np.int64)
    if volumes(v, f, np.zeros(len(v), dtype=int))[0] < 0:
        f = f[:, ::-1].copy()
    v, f = biggest_part(v, f)
    v = relax(field, v, f, 0.5 * h, 1)
    if faces:
        v, f = decimate(v, f, faces)
    v = relax(field, v, f, 0.5 * h, rounds)
    v = project(field, v, 0.5 * h, steps=2)
    n = gradient(field, v, normal_eps or 0.3 * h)
    n /= np.maximum(np.linalg.norm(n, axis=1), 1e-12)[:, None]
    return Mesh(v, f, n)


def check(name, mesh):
    """Raise unless every component is a closed, outward, sound 2-manifold."""
    v = mesh.vertices.astype(np.float32).astype(float)
    f, n = mesh.faces, mesh.normals

    def require(ok, what):
        if not ok:
            raise AssertionError(f"{name}: {what}")

    require(np.isfinite(v).all() and np.isfinite(n).all(), "a number is not finite")
    require(np.abs(np.linalg.norm(n, axis=1) - 1).max() < 1e-3, "a normal is not of unit length")
    require(len(np.unique(f)) == len(v), "a vertex is in no face")
    half = np.vstack([f[:, [0, 1]], f[:, [1, 2]], f[:, [2, 0]]])
    key = half[:, 0] * len(v) + half[:, 1]
    back = half[:, 1] * len(v) + half[:, 0]
    order = np.argsort(key)
    require((np.diff(key[order]) > 0).all(), "two faces run the same way along an edge")
    spot = np.searchsorted(key[order], back)
    require((spot < len(key)).all() and (key[order][np.minimum(spot, len(key) - 1)] == back).all(),
            "an edge is open")
    twin = order[spot]
    m = len(f)
    before = (np.arange(3 * m) - m) % (3 * m)  # the half edge that ends where this begins
    fans, _ = connected_components(sparse.coo_matrix(
        (np.ones(3 * m), (np.arange(3 * m), twin[before])), shape=(3 * m, 3 * m)), directed=False)
    require(fans == len(v), "faces meet in a single vertex")
    area = 0.5 * np.linalg.norm(face_cross(v, f), axis=1)
    size = np.ptp(v, axis=0).max()
    require(area.min() > 1e-10 * size * size, f"a face is degenerate ({area.min():.2e})")
    labels = component_labels(len(v), f)
    require((volumes(v, f, labels) > 0).all(), "a component is inside out")
    flat = face_cross(v, f)
    agree = np.einsum("ij,ij->i", flat, n[f].sum(axis=1)) > 0
    require(agree.mean() > 0.998, f"normals disagree with {100 - 100 * agree.mean():.2f}% of faces")
    return labels.max() + 1
