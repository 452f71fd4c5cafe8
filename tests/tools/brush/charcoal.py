# SPDX-License-Identifier: GPL-3.0-or-later
"""Charcoal: pressure against the paper's tooth, smudged and drawn over."""
import numpy as np
from scipy.ndimage import gaussian_filter

from .sheet import (Bank, Sheet, fractal, hex_colour, noise, paper_height, relief, settle,
                    smoothstep, tone_at)

# Optical density of packed charcoal in red, green and blue light: a sepia black.
SEPIA_BLACK = np.array([3.7, 4.1, 4.5], np.float32)


def rub_stroke(dust, sheet, streaks, tooth, rng, pressure, length, width, angle):
    """Drags the stick: dust stays where the tooth is high enough to meet its pressure."""
    x, y = sheet.random_spot(rng)
    t = sheet.part(x)
    push = pressure(t)
    if push <= 0.02:
        return
    found = sheet.window(x, y, angle, 0.5 * length + width, rng.normal(0, 0.004))
    if found is None:
        return
    at, u, v = found
    k = sheet.scale
    line = streaks.sample(v * k, u * k, rng)
    across = smoothstep(0.0, 1.0, (0.5 * width - np.abs(v - rng.uniform(-0.2, 0.2) * width)) / (0.22 * width) + 0.25 * line)
    run = np.abs(u) / (0.5 * length)
    ends = smoothstep(0.0, 0.5, 1.0 - run + 0.05 * line)
    contact = push * across * ends * (1.0 + 0.30 * line)
    met = smoothstep(-0.30, 0.30, tooth[at] + 1.15 * contact - 1.0)
    packed = np.clip(0.10 + 0.95 * contact * (0.55 + 0.45 * tooth[at]), 0, 1.1)
    dust[at] += met * 0.55 * np.maximum(packed - dust[at], 0.0)


def smudge(dust, sheet, rng, banks):
    """A fingertip's drag: dust is pushed along and down into the pits."""
    x, y = sheet.random_spot(rng)
    length, width, angle = rng.uniform(22, 60), rng.uniform(9, 20), rng.normal(-0.75, 0.6)
    found = sheet.window(x, y, angle, 0.5 * length + width)
    if found is None:
        return
    at, u, v = found
    wide = smoothstep(0.0, 0.5, 1 - np.hypot(u / (0.5 * length), v / (0.5 * width)) + 0.15 * banks.cut(u.shape, rng))
    weight = wide * rng.uniform(0.25, 0.75)
    soft = gaussian_filter(dust[at], (2.2 * sheet.scale, 2.2 * sheet.scale))
    dust[at] += weight * (0.92 * soft - dust[at])


def paint(seed=1873):
    """The strip, linear light."""
    rng = np.random.default_rng(seed)
    sheet = Sheet()
    k = sheet.scale
    tooth = paper_height(sheet, rng, grain=1.9, fibre=0.3)
    tile = (1024, 1024)
    streaks = noise(tile, rng, (0.5 * k, 18 * k)) + 0.7 * noise(tile, rng, (1.6 * k, 30 * k))
    streaks = Bank(streaks / streaks.std())
    clouds = Bank(fractal(tile, rng, 5 * k, 3))
    dust = np.zeros(sheet.shape, np.float32)

    def press(scatter, firm=1.0):
        """The hand's pressure along the strip: firm in the darks, hardly there in the lights."""
        return lambda t: firm * np.clip(1.05 - 0.93 * t ** 0.8 + rng.normal(0, scatter), 0, 1.3)

    slant = -0.95
    for _ in range(1100):
        rub_stroke(dust, sheet, streaks, tooth, rng, press(0.06, 0.8), rng.uniform(40, 90),
                   rng.uniform(12, 26), rng.normal(slant, 0.2))
    for _ in range(700):
        smudge(dust, sheet, rng, clouds)
    for _ in range(1300):
        cross = 1.1 if rng.random() < 0.12 else 0.0
        rub_stroke(dust, sheet, streaks, tooth, rng, press(0.14), rng.uniform(26, 70),
                   rng.uniform(4, 12), rng.normal(slant + cross, 0.16))
    for _ in range(1500):
        rub_stroke(dust, sheet, streaks, tooth, rng, press(0.2, 1.15), rng.uniform(18, 55),
                   rng.uniform(1.4, 3.4), rng.normal(slant, 0.2))
    cream = hex_colour("f7f0e0")
    fibres = 1.0 + 0.010 * noise(sheet.shape, rng, (0.5 * k, 3 * k))
    sheet_light = relief(tooth, 0.06) * fibres
    colour = cream * np.exp(-dust[..., None] * SEPIA_BLACK) * sheet_light[..., None]
    return settle(sheet.scan(colour), cream)
