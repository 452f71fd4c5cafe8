# SPDX-License-Identifier: GPL-3.0-or-later
"""Watercolour: translucent washes with wet edges, granulation and back-runs on rough paper."""
import numpy as np

from .sheet import (Bank, Sheet, fractal, hex_colour, noise, paper_height, relief, settle,
                    smoothstep)

# Optical density of a full wash of each pigment in red, green and blue light.
INDIGO = np.array([4.4, 3.0, 1.75], np.float32)
ULTRAMARINE = np.array([2.3, 1.65, 0.28], np.float32)
ROSE = np.array([0.16, 1.55, 0.85], np.float32)
OCHRE = np.array([0.10, 0.42, 1.45], np.float32)
TURQUOISE = np.array([2.6, 0.55, 0.45], np.float32)
PIGMENTS = np.stack([INDIGO, ULTRAMARINE, ROSE, OCHRE, TURQUOISE])
# How strongly each pigment settles into the paper's pits.
GRANULATION = np.array([0.28, 0.75, 0.22, 0.30, 0.12], np.float32)

# Amount of each pigment along the strip, 0..1: indigo, ultramarine, rose, ochre, turquoise.
STATIONS = np.array([0.0, 0.15, 0.3, 0.45, 0.6, 0.75, 0.9, 1.0])
AMOUNTS = np.array([
    [0.98, 0.60, 0.26, 0.09, 0.02, 0.00, 0.00, 0.00],
    [0.22, 0.32, 0.40, 0.36, 0.20, 0.08, 0.02, 0.00],
    [0.14, 0.20, 0.30, 0.44, 0.48, 0.34, 0.15, 0.06],
    [0.16, 0.10, 0.05, 0.05, 0.15, 0.28, 0.24, 0.13],
    [0.06, 0.16, 0.24, 0.13, 0.04, 0.02, 0.01, 0.00]])


def load_at(t):
    """Pigment amounts at t along the strip; t any shape, pigments come first."""
    return np.stack([np.interp(t, STATIONS, row) for row in AMOUNTS]).astype(np.float32)


def lay_wash(density, sheet, banks, paper, rng, share):
    """One loaded brush mark, laid on what is dry: share is its part of the full colour."""
    x, y = sheet.random_spot(rng)
    t = sheet.part(x)
    length, width = rng.uniform(26, 84), rng.triangular(7, 12, 32)
    angle = rng.normal(-0.62, 0.34) + (np.pi if rng.random() < 0.5 else 0.0)
    found = sheet.window(x, y, angle, 0.5 * length + 0.5 * width + 8, rng.normal(0, 0.009))
    if found is None:
        return
    at, u, v = found
    wobble, fine, flow = (bank.cut(u.shape, rng) for bank in banks)
    belly = 0.5 * width * (1.0 - 0.5 * np.clip(u / length + 0.1, 0, 0.6) ** 1.5)
    inside = (np.minimum(belly - np.abs(v), 0.5 * length - np.abs(u))
              - 2.0 * smoothstep(3.0, 0.0, 0.5 * length - np.abs(u)) * smoothstep(4.0, 0.0, belly - np.abs(v))
              + 1.5 * wobble + 0.30 * fine)
    kind = rng.random()
    lost = smoothstep(-0.6, 0.9, flow + rng.normal(-0.1, 0.5))  # where the edge met damp paper
    crisp, soft = smoothstep(-0.5, 0.6, inside), smoothstep(-5.0, 7.0, inside)
    if kind < 0.22:                                     # into wet paper: no edge at all
        lost = 1.0
    body = crisp + lost * (soft - crisp)
    rim = (1.0 - lost) * rng.uniform(0.5, 1.7) * np.exp(-np.maximum(inside, 0) / rng.uniform(0.7, 1.4))
    if kind > 0.82:                                     # a drier brush skips the paper's pits
        body = body * smoothstep(-0.14, 0.14, paper[at] - rng.uniform(0.3, 0.6))
    pooled = 1.0 + 0.16 * flow + 0.5 * u / length       # pigment runs to where the brush leaves
    amount = share * rng.uniform(0.6, 1.25) * np.clip(body * (pooled + rim), 0, None)
    here = load_at(np.clip(t, 0, 1))
    turn = np.exp(rng.normal(0, 0.5, len(here))).astype(np.float32)
    local = 0.55 * load_at(sheet.along()[at[1]])[:, None, :] + 0.45 * here[:, None, None]
    density[(slice(None),) + at] += amount * local * turn[:, None, None]


def drop_water(density, sheet, banks, rng):
    """A back-run: clear water pushes pigment outwards to a ragged rim."""
    x, y = sheet.random_spot(rng)
    radius = rng.uniform(6, 15)
    found = sheet.window(x, y, rng.uniform(0, 6.28), 2.2 * radius + 4)
    if found is None:
        return
    at, u, v = found
    wobble, fine, _ = (bank.cut(u.shape, rng) for bank in banks)
    inside = radius - np.hypot(u, 1.3 * v) + 0.42 * radius * wobble + 1.3 * fine
    washed = smoothstep(-0.5, 0.9 * radius, inside) * rng.uniform(0.15, 0.45)
    rim = rng.uniform(0.10, 0.35) * np.exp(-(inside / rng.uniform(0.8, 1.6)) ** 2)
    density[(slice(None),) + at] *= 1.0 - washed + rim


def paint(seed=1842):
    """The strip, linear light."""
    rng = np.random.default_rng(seed)
    sheet = Sheet()
    k = sheet.scale
    paper = paper_height(sheet, rng, grain=1.45, cloud=0.12)
    tile = (768, 768)
    banks = (Bank(fractal(tile, rng, 7 * k, 3)), Bank(fractal(tile, rng, 1.6 * k, 2)),
             Bank(fractal(tile, rng, 9 * k, 4, 0.7)))

    t = np.clip(sheet.along()[None, :] + 0.012 * fractal(sheet.shape, rng, 10 * k, 4), 0, 1)
    density = 0.34 * load_at(t) * np.exp(0.07 * fractal(sheet.shape, rng, 9 * k, 4, 0.6))
    for turn in range(1000):
        lay_wash(density, sheet, banks, paper, rng, share=0.10)
        if turn % 11 == 0:
            drop_water(density, sheet, banks, rng)

    pits = 1.0 - 2.0 * paper
    flock = fractal(sheet.shape, rng, 1.3 * k, 2)
    for one, settling in zip(density, GRANULATION):
        one *= np.clip(1.0 + settling * (0.62 * pits + 0.10 * flock), 0.05, None)
    white = hex_colour("fbf6ea")
    colour = white * np.exp(-np.einsum("nyx,nc->yxc", density, PIGMENTS))
    cockle = noise(sheet.shape, rng, (0.9 * k, 1.3 * k)) + 0.5 * noise(sheet.shape, rng, 0.5 * k)
    colour *= relief(cockle, 0.06)[..., None]
    return settle(sheet.scan(colour), white, across=(6.0, 17.0))
