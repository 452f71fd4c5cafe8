# SPDX-License-Identifier: GPL-3.0-or-later
"""Charcoal: pressure against the paper's tooth, smudged and drawn over."""
import numpy as np
from scipy.ndimage import gaussian_filter

from .sheet import (Bank, Sheet, fractal, hex_colour, noise, paper_height, relief, settle,
                    smoothstep)

# Optical density of packed charcoal in red, green and blue light: a sepia black.
SEPIA_BLACK = np.array([3.5, 3.95, 4.4], np.float32)


def rub_stroke(dust, sheet, streaks, tooth, rng, pressure, length, width, angle, softness=0.3):
    """Drags the stick: dust stays where the tooth is high enough to meet its pressure.

    pressure is a function of the place along the strip, 0..1; softness is how
    far (in tooth heights) the stick gives way.
    """
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
    inside = 0.5 * width - np.abs(v - rng.uniform(-0.2, 0.2) * width)
    across = smoothstep(0.0, 1.0, inside / (0.22 * width) + 0.25 * line)
    run = np.abs(u) / (0.5 * length)
    ends = smoothstep(0.0, 0.7, 1.0 - run + 0.08 * line)
    contact = push * across * ends * (1.0 + 0.30 * line)
    crumb = 0.16 * streaks.sample(v * k * 2.5, u * k * 9.0, rng)  # the stick's own grain
    met = smoothstep(-softness, softness, tooth[at] + crumb + 1.15 * contact - 1.0)
    packed = np.clip(0.10 + 0.95 * contact * (0.55 + 0.45 * tooth[at]), 0, 1.1)
    dust[at] += met * 0.55 * np.maximum(packed - dust[at], 0.0)


def smudge(dust, sheet, rng, clouds, angle):
    """A fingertip's drag: dust is pushed along the stroke and down into the pits."""
    x, y = sheet.random_spot(rng)
    length, width = rng.uniform(26, 60), rng.uniform(8, 18)
    found = sheet.window(x, y, angle, 0.5 * length + width)
    if found is None:
        return
    at, u, v = found
    wide = smoothstep(0.0, 0.7, 1 - np.hypot(u / (0.5 * length), v / (0.5 * width))
                      + 0.25 * clouds.cut(u.shape, rng))
    dragged = np.zeros_like(u)
    steps = range(-8, 9)                                # px along the finger's way
    for step in steps:
        dragged += np.roll(dust[at], (int(step * sheet.scale * np.sin(angle)),
                                      int(step * sheet.scale * np.cos(angle))), (0, 1))
    dragged = gaussian_filter(dragged / len(steps), 0.6 * sheet.scale)
    dust[at] += wide * rng.uniform(0.3, 0.8) * (0.95 * dragged - dust[at])


def paint(seed=1873):
    """The strip, linear light."""
    rng = np.random.default_rng(seed)
    sheet = Sheet()
    k = sheet.scale
    tooth = paper_height(sheet, rng, grain=1.55, fibre=0.3, cloud=0.12)
    tile = (1024, 1024)
    streaks = noise(tile, rng, (0.5 * k, 18 * k)) + 0.7 * noise(tile, rng, (1.6 * k, 30 * k))
    streaks = Bank(streaks / streaks.std())
    clouds = Bank(fractal(tile, rng, 5 * k, 3))
    part = sheet.along()[None, :]
    dust = 0.40 * np.clip(1.05 - 1.0 * part ** 0.8, 0, 1) ** 1.5 * np.clip(
        1.0 + 0.22 * fractal(sheet.shape, rng, (3 * k), 3), 0.2, None)  # powder, rubbed in with a rag

    def press(scatter, firm=1.0):
        """The hand's pressure along the strip: firm in the darks, hardly there in the lights."""
        return lambda t: firm * np.clip(1.05 - 0.86 * t ** 0.85 + rng.normal(0, scatter), 0, 1.3)

    slant = -0.95
    for _ in range(1500):                               # rubbed in with the side of the stick
        rub_stroke(dust, sheet, streaks, tooth, rng, press(0.05, 0.85), rng.uniform(40, 90),
                   rng.uniform(12, 26), rng.normal(slant, 0.2), softness=0.5)
    for _ in range(900):
        smudge(dust, sheet, rng, clouds, rng.normal(slant, 0.25))
    for _ in range(1500):
        cross = 1.1 if rng.random() < 0.06 else 0.0
        rub_stroke(dust, sheet, streaks, tooth, rng, press(0.10), rng.uniform(26, 70),
                   rng.uniform(4, 12), rng.normal(slant + cross, 0.16), softness=0.22)
    for _ in range(1100):                               # the stick's sharp edge
        rub_stroke(dust, sheet, streaks, tooth, rng, press(0.10, 1.08), rng.uniform(18, 55),
                   rng.uniform(1.4, 3.4), rng.normal(slant, 0.2), softness=0.22)
    cream = hex_colour("faf5e8")
    fibres = 1.0 + 0.010 * noise(sheet.shape, rng, (0.5 * k, 3 * k))
    sheet_light = relief(tooth, 0.11) * fibres
    colour = cream * np.exp(-dust[..., None] * SEPIA_BLACK) * sheet_light[..., None]
    return settle(sheet.scan(colour), cream, across=(5.0, 24.0))
