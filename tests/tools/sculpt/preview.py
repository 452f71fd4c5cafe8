# SPDX-License-Identifier: GPL-3.0-or-later
"""A small z-buffer renderer, to look at what was sculpted.

Shades half-Lambert, (1 + n.l) / 2, with the meshes' own normals, the way the
studio picks a place along the paint.
"""

import numpy as np
from PIL import Image

PAINT = np.array([[28, 22, 34], [66, 40, 52], [128, 72, 58], [192, 132, 88],
                  [228, 194, 146], [250, 240, 216]], dtype=float)
GROUND = np.array([86, 84, 88], dtype=float)


def camera_axes(azimuth, elevation):
    """Rows right, up, towards the viewer; degrees, azimuth 0 looks at +Z."""
    a, e = np.radians(azimuth), np.radians(elevation)
    back = np.array([np.sin(a) * np.cos(e), np.sin(e), np.cos(a) * np.cos(e)])
    right = np.array([np.cos(a), 0.0, -np.sin(a)])
    return np.stack([right, np.cross(back, right), back])


def render(meshes, azimuth, elevation, size=800, light=(-0.5, 0.75, 0.6), samples=2,
           reach=1.15, distance=7.0, paint=True, centre=(0, 0, 0)):
    """An RGB image; `light` is in view space, `reach` the half width in view."""
    axes = camera_axes(azimuth, elevation)
    px = size * samples
    light = np.asarray(light, dtype=float)
    light /= np.linalg.norm(light)
    keys, depths, tones = [], [], []
    for mesh in meshes:
        v = (mesh.vertices - centre) @ axes.T
        n = mesh.normals @ axes.T
        shrink = distance / (distance - v[:, 2])
        sx = (v[:, 0] * shrink / reach * 0.5 + 0.5) * px
        sy = (0.5 - v[:, 1] * shrink / reach * 0.5) * px
        f = mesh.faces
        x, y = sx[f], sy[f]
        area = (x[:, 1] - x[:, 0]) * (y[:, 2] - y[:, 0]) - (x[:, 2] - x[:, 0]) * (y[:, 1] - y[:, 0])
        front = area < -1e-9
        f, x, y, area = f[front], x[front], y[front], area[front]
        x0 = np.clip(np.floor(x.min(1)), 0, px - 1).astype(int)
        x1 = np.clip(np.ceil(x.max(1)), 0, px - 1).astype(int)
        y0 = np.clip(np.floor(y.min(1)), 0, px - 1).astype(int)
        y1 = np.clip(np.ceil(y.max(1)), 0, px - 1).astype(int)
        w = x1 - x0 + 1
        count = w * (y1 - y0 + 1)
        for part in np.array_split(np.arange(len(f)), max(1, int(count.sum() // 3_000_000) + 1)):
            c = count[part]
            owner = np.repeat(part, c)
            local = np.arange(c.sum()) - np.repeat(np.cumsum(c) - c, c)
            ix = x0[owner] + local % w[owner]
            iy = y0[owner] + local // w[owner]
            qx, qy = ix + 0.5, iy + 0.5
            X, Y, A = x[owner], y[owner], area[owner]
            b1 = ((qx - X[:, 0]) * (Y[:, 2] - Y[:, 0]) - (X[:, 2] - X[:, 0]) * (qy - Y[:, 0])) / A
            b2 = ((X[:, 1] - X[:, 0]) * (qy - Y[:, 0]) - (qx - X[:, 0]) * (Y[:, 1] - Y[:, 0])) / A
            b0 = 1.0 - b1 - b2
            ok = (b0 >= 0) & (b1 >= 0) & (b2 >= 0)
            owner, ix, iy, b = owner[ok], ix[ok], iy[ok], np.stack([b0[ok], b1[ok], b2[ok]], axis=1)
            corner = f[owner]
            nn = np.einsum("ij,ijk->ik", b, n[corner])
            nn /= np.maximum(np.linalg.norm(nn, axis=1), 1e-9)[:, None]
            keys.append(iy * px + ix)
            depths.append((b * v[corner, 2]).sum(1))
            tones.append(0.5 + 0.5 * (nn @ light))
    key, depth, tone = map(np.concatenate, (keys, depths, tones))
    order = np.argsort(depth, kind="stable")
    plane = np.full(px * px, -1.0)
    plane[key[order]] = tone[order]
    colour = np.empty((px * px, 3))
    stops = np.linspace(0, 1, len(PAINT))
    for k in range(3):
        ramp = np.interp(plane, stops, PAINT[:, k]) if paint else plane * 255.0
        colour[:, k] = np.where(plane < 0, GROUND[k], ramp)
    colour = colour.reshape(size, samples, size, samples, 3).mean(axis=(1, 3))
    return Image.fromarray(colour.clip(0, 255).astype(np.uint8))


def sheet(meshes, views, columns=2, **options):
    """Several views side by side; each is (azimuth, elevation) in degrees."""
    images = [render(meshes, a, e, **options) for a, e in views]
    w, h = images[0].size
    rows = -(-len(images) // columns)
    out = Image.new("RGB", (w * columns, h * rows))
    for i, image in enumerate(images):
        out.paste(image, ((i % columns) * w, (i // columns) * h))
    return out
