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


def already_drawn(laid, sheet, spine, limit):
    """Whether more than limit (0..1) of a stroke would lie on others of its layer; notes it if not."""
    at = np.clip(np.rint(spine).astype(int) + sheet.bleed, 1, np.array(laid.shape)[::-1] - 2)
    if laid[at[:, 1], at[:, 0]].mean() > limit:
        return True
    for dy in (-1, 0, 1):
        for dx in (-1, 0, 1):
            laid[at[:, 1] + dy, at[:, 0] + dx] = True
    return False


def pen_line(ink, laid, sheet, rng, x, y, angle, length, nib, bend, limit):
    """One stroke from (x, y) px: pressed, carried with a wobble, lifted to a taper."""
    k = sheet.scale
    n = max(8, int(length / 1.8))
    s = np.linspace(0.0, 1.0, n)
    wander = np.cumsum(rng.normal(0, 0.05, n))
    off = wander - np.linspace(wander[0], wander[-1], n) + bend * length * (s * s - s)
    c, d = np.cos(angle), np.sin(angle)
    px = x + c * s * length - d * off
    py = y + d * s * length + c * off
    if already_drawn(laid, sheet, np.stack([px, py], 1), limit):
        return
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


def hatch_patch(ink, laid, sheet, rng, x, y, angle, tone, layer, limit):
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
        pen_line(ink, laid, sheet, rng, x + c * back - s * across, y + s * back + c * across,
                 angle + fan * (i - 0.5 * count) + rng.normal(0, 0.022), own, nib, bend, limit)


def cover_of(ink):
    """Light that ink takes away, 0..1, of green light."""
    return 1.0 - np.exp(-BLUE_BLACK[1] * np.minimum(ink, 1.5))


def hatch_layer(ink, sheet, rng, layer, cap, drift):
    """Hatches in one direction wherever the tone still wants it, up to cap (light taken, 0..1)."""
    cell = 8 * sheet.scale                              # tone is judged on 8 px squares
    rows, columns = sheet.shape[0] // cell, sheet.shape[1] // cell
    along = np.clip((np.arange(columns) * 8 + 4 - sheet.bleed) / sheet.width, 0, 1)
    full = 1.0 - (tone_at(along) / 0.965) ** 2.2
    wanted = np.minimum(full, cap)[None, :].repeat(rows, 0)
    laid = np.zeros((sheet.height + 2 * sheet.bleed, sheet.width + 2 * sheet.bleed), bool)
    for turn in range(6000):
        if turn % 12 == 0:
            have = cover_of(ink[:rows * cell, :columns * cell]).reshape(rows, cell, columns, cell)
            have = gaussian_filter(have.mean((1, 3)), 0.8)
            lack = np.maximum(wanted - have, 0) / (wanted + 0.05)
            lack[lack < 0.06] = 0
            if lack.max() < 0.10:
                return
            odds = (lack ** 1.5).ravel().cumsum()
        pick = int(np.searchsorted(odds, rng.uniform(0, odds[-1])))
        j, i = divmod(min(pick, rows * columns - 1), columns)
        angle = DIRECTIONS[layer] + 0.06 * drift[j, i] + rng.normal(0, 0.03)
        hatch_patch(ink, laid, sheet, rng, i * 8 + rng.uniform(0, 8) - sheet.bleed,
                    j * 8 + rng.uniform(0, 8) - sheet.bleed, angle,
                    float(tone_at(along[i])), layer, 0.3 + turn / 2500)


def paint(seed=1499):
    """The strip, linear light."""
    rng = np.random.default_rng(seed)
    sheet = Sheet(scale=4)
    ink = np.zeros(sheet.shape, np.float32)
    ivory = hex_colour("faf6ea")
    cells = (sheet.shape[0] // (8 * sheet.scale), sheet.shape[1] // (8 * sheet.scale))
    wash = np.clip(1.0 - sheet.along() / 0.6, 0, 1) ** 1.5  # thin ink, brushed under the darks
    ink += 0.15 * wash * np.clip(1.0 + 0.2 * fractal(sheet.shape, rng, 24, 4), 0, None)
    for layer, cap in enumerate(CAPS):
        hatch_layer(ink, sheet, rng, layer, cap, noise(cells, rng, 3.0))
    ink = np.minimum(ink, 1.6) * np.clip(1.0 + 0.10 * noise(sheet.shape, rng, 2.0), 0.5, None)
    grain = 1.0 + 0.008 * fractal(sheet.shape, rng, 5, 2)
    colour = ivory * np.exp(-ink[..., None] * BLUE_BLACK) * grain[..., None]
    return settle(sheet.scan(colour, blur=0.22), ivory, across=(4.0, 40.0), strength=0.0)
