# SPDX-License-Identifier: GPL-3.0-or-later
"""Pen hatching: patches of single strokes, crossed over and over until the tone is reached."""
import numpy as np
from PIL import Image, ImageDraw
from scipy.ndimage import gaussian_filter

from .sheet import Sheet, fractal, hex_colour, noise, settle, tone_at

# Optical density of undiluted blue-black ink in red, green and blue light.
BLUE_BLACK = np.array([3.6, 3.15, 2.35], np.float32)
# The hatching directions in the order in which they are laid, radians, and the
# part of the light (0..1) that each layer and those under it may take at most.
DIRECTIONS = (-0.95, -0.40, -1.50, 0.12, 0.75, -0.70)
LINE_GAP = 3.9
CAPS = (0.40, 0.60, 0.76, 0.88, 0.95, 1.0)


def pen_line(ink, sheet, rng, x, y, angle, length, nib, bend):
    """One stroke from (x, y) px: pressed, carried with a wobble, lifted to a taper."""
    k = sheet.scale
    n = max(6, int(length / 2.5))
    s = np.linspace(0.0, 1.0, n)
    wander = np.cumsum(rng.normal(0, 0.055, n))
    off = wander - np.linspace(wander[0], wander[-1], n) + bend * length * (s * s - s)
    c, d = np.cos(angle), np.sin(angle)
    px = x + c * s * length - d * off
    py = y + d * s * length + c * off
    swell = np.minimum(1.0, s / 0.10 + 0.45) * np.minimum(1.0, (1.0 - s) / rng.uniform(0.25, 0.6) + 0.12)
    half = 0.5 * nib * swell * np.clip(1 + 0.10 * rng.standard_normal(n), 0.6, 1.4)
    side = np.array([-d, c])
    spine = (np.stack([px, py], 1) + sheet.bleed) * k
    left, right = spine + half[:, None] * k * side, spine - half[:, None] * k * side
    outline = np.concatenate([left, right[::-1]])
    x0, y0 = np.floor(outline.min(0) - 1).astype(int)
    x1, y1 = np.ceil(outline.max(0) + 2).astype(int)
    rows, columns = sheet.shape
    cx0, cy0, cx1, cy1 = max(x0, 0), max(y0, 0), min(x1, columns), min(y1, rows)
    if cx0 >= cx1 or cy0 >= cy1:
        return
    stamp = Image.new("L", (cx1 - cx0, cy1 - cy0))
    ImageDraw.Draw(stamp).polygon([(px - cx0, py - cy0) for px, py in outline], fill=255)
    ink[cy0:cy1, cx0:cx1] += np.asarray(stamp, np.float32) * (rng.uniform(0.62, 1.0) / 255.0)


def hatch_patch(ink, sheet, rng, x, y, angle, tone, layer):
    """A handful of parallel strokes round (x, y) px, as the wrist makes them in one go.

    The eye sets each new patch into the rows already there: strokes keep to
    lines LINE_GAP px apart across the layer's direction, or to every other one in the lights.
    """
    sparse = rng.random() < 3.0 * (tone - 0.55)
    count = int(rng.integers(3, 6)) if sparse else int(rng.integers(5, 10))
    gap = LINE_GAP * (2 if sparse else 1)
    main = np.array([-np.sin(DIRECTIONS[layer]), np.cos(DIRECTIONS[layer])])
    row = main @ (x, y)
    x, y = np.array([x, y]) + main * (np.rint(row / LINE_GAP) * LINE_GAP - row)
    length = rng.uniform(26, 46) * (1.12 - 0.6 * tone) * (1.0 - 0.06 * layer)
    nib = rng.uniform(1.3, 1.75) * (1.15 - 0.42 * tone)
    fan, bend = rng.normal(0, 0.008), rng.normal(0.05, 0.03)
    c, s = np.cos(angle), np.sin(angle)
    stagger = rng.normal(0, 1.5)                        # the row's ends lean as the wrist turns
    for i in range(count):
        across = (i - count // 2) * gap + rng.normal(0, 0.38)
        own = length * rng.uniform(0.78, 1.15)
        back = -0.5 * own + rng.normal(0, 0.06) * length + stagger * (i - 0.5 * count)
        pen_line(ink, sheet, rng, x + c * back - s * across, y + s * back + c * across,
                 angle + fan * (i - 0.5 * count) + rng.normal(0, 0.022), own, nib, bend)


def cover_of(ink):
    """Light that ink takes away, 0..1, of green light."""
    return 1.0 - np.exp(-BLUE_BLACK[1] * np.minimum(ink, 1.5))


def hatch_layer(ink, sheet, rng, layer, cap, drift):
    """Hatches in one direction wherever the tone still wants it, up to cap (light taken, 0..1)."""
    cell = 8 * sheet.scale                              # tone is judged on 8 px squares
    rows, columns = sheet.shape[0] // cell, sheet.shape[1] // cell
    along = np.clip((np.arange(columns) * 8 + 4 - sheet.bleed) / sheet.width, 0, 1)
    full = 1.0 - (tone_at(along) / 0.955) ** 2.2
    wanted = np.minimum(full, cap)[None, :].repeat(rows, 0)
    for turn in range(6000):
        if turn % 12 == 0:
            have = cover_of(ink[:rows * cell, :columns * cell]).reshape(rows, cell, columns, cell).mean((1, 3))
            have = gaussian_filter(have, 0.8)
            lack = np.maximum(wanted - have, 0) / (wanted + 0.05)
            lack[lack < 0.06] = 0
            if lack.max() < 0.10:
                return
            odds = (lack ** 1.5).ravel().cumsum()
        pick = int(np.searchsorted(odds, rng.uniform(0, odds[-1])))
        j, i = divmod(min(pick, rows * columns - 1), columns)
        angle = DIRECTIONS[layer] + 0.06 * drift[j, i] + rng.normal(0, 0.03)
        hatch_patch(ink, sheet, rng, i * 8 + rng.uniform(0, 8) - sheet.bleed,
                    j * 8 + rng.uniform(0, 8) - sheet.bleed, angle,
                    float(tone_at(along[i])), layer)


def paint(seed=1499):
    """The strip, linear light."""
    rng = np.random.default_rng(seed)
    sheet = Sheet(scale=4)
    ink = np.zeros(sheet.shape, np.float32)
    ivory = hex_colour("f8f2e1")
    cells = (sheet.shape[0] // (8 * sheet.scale), sheet.shape[1] // (8 * sheet.scale))
    for layer, cap in enumerate(CAPS):
        hatch_layer(ink, sheet, rng, layer, cap, noise(cells, rng, 3))
    ink = np.minimum(ink, 1.6) * np.clip(1.0 + 0.10 * noise(sheet.shape, rng, 2.0), 0.5, None)
    grain = 1.0 + 0.008 * fractal(sheet.shape, rng, 5, 2)
    colour = ivory * np.exp(-ink[..., None] * BLUE_BLACK) * grain[..., None]
    return settle(sheet.scan(colour), ivory, across=(12.0, 40.0), strength=0.0)
