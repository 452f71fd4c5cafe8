# SPDX-License-Identifier: GPL-3.0-or-later
"""Oil: short loaded bristle strokes, streaked, ridged and broken, in side light."""
import numpy as np
from scipy.ndimage import gaussian_filter

from .pigment import Palette, mix
from .sheet import Bank, Sheet, fractal, hex_colour, noise, settle, smoothstep, tone_at

# From the warm black of the shadows to lead white; the second palette's cool
# greys and greens are the broken colour between.
WARM = Palette("0d0a12", "2b0f1a", "6d1a1c", "a8401c", "d27f2c", "e6b55c", "f3dca2", "fdf6e6")
COOL = Palette("080d14", "10222c", "28434a", "4f6d68", "86998a", "b5bfae", "dbdccf", "f6f3ea")


def canvas_weave(sheet, rng):
    """Height of the primed linen, about -1..1: uneven threads, 3.1 px apart."""
    rows, columns = sheet.shape
    y, x = np.mgrid[0:rows, 0:columns].astype(np.float32) / sheet.scale
    x = x + 0.5 * noise(sheet.shape, rng, 14)
    y = y + 0.5 * noise(sheet.shape, rng, 14)
    over = np.sin(x * (np.pi / 3.1)) * np.sin(y * (np.pi / 3.1))
    return over * (0.7 + 0.3 * noise(sheet.shape, rng, 9)) + 0.35 * noise(sheet.shape, rng, 2)


def brush_stroke(colour, height, sheet, banks, weave, rng, late):
    """One stroke. late runs 0..1 over the painting: thin long scrubs first, then thick touches."""
    x, y = sheet.random_spot(rng)
    t = sheet.part(x)
    body = 0.5 + 0.5 * t                              # lights are painted thicker
    length = rng.uniform(30, 60) * (1.15 - 0.4 * late - 0.2 * t)
    width = rng.uniform(7, 15) * (1.1 - 0.35 * late)
    angle = rng.normal(-0.95 + 0.55 * t, 0.38) + (np.pi if rng.random() < 0.35 else 0.0)
    found = sheet.window(x, y, angle, 0.5 * length + 0.5 * width + 4, rng.normal(0, 0.012))
    if found is None:
        return
    at, u, v = found
    streaks, mottle = banks
    k = sheet.scale
    run = u / length + 0.5                              # 0 where the brush lands, 1 where it lifts
    hair = streaks.sample(v * k, u * k, rng)            # bristle marks
    tint = streaks.sample(v * k * 0.6, u * k * 0.7, rng)
    ragged = streaks.sample(v * k, u * k * 0.15, rng)
    edge = 0.5 * width * (1.0 - 0.25 * smoothstep(0.55, 1.0, run)) - np.abs(v) + 0.5 * hair
    start = (run * length) + 2.0 * ragged
    stop = (1.0 - run) * length + 4.0 * ragged
    shape = smoothstep(-0.5, 0.7, edge) * smoothstep(-0.4, 0.8, start) * smoothstep(-0.5, 2.0, stop)
    load = rng.uniform(0.42, 1.2) * (1.15 - rng.uniform(0.45, 1.1) * np.clip(run, 0, 1))
    catch = 0.75 * hair + 0.35 * weave[at] + 0.5 * height[at]
    cover = shape * smoothstep(-0.25, 0.35, catch + 2.6 * (load - 0.45))
    if not cover.any():
        return
    value = tone_at(t) + rng.normal(0, 0.035 + 0.045 * t * (1 - t)) + 0.35 * (
        tone_at(sheet.along()[at[1]])[None, :] - tone_at(t))
    value = value + 0.030 * tint * (0.4 + t)
    cool = np.clip(rng.choice([0.04, 0.15, 0.75], p=[0.6, 0.26, 0.14]) + 0.10 * tint, 0, 1)
    paint = mix(WARM.at(value), COOL.at(value), cool)
    solid = cover * (0.80 + 0.2 * np.clip(load, 0, 1))
    colour[at] += solid[..., None] * (paint - colour[at])
    ridge = np.exp(-(edge / 0.9) ** 2) * 0.9 + np.exp(-(start / 1.4) ** 2) * 0.3 \
        + np.exp(-((stop - 1.5) / 1.6) ** 2) * 0.7
    pile = body * np.clip(load, 0.2, 1.4) * (0.55 + 0.42 * hair + ridge)
    height[at] += cover * (pile + 0.15 * mottle.cut(u.shape, rng) * body - 0.72 * height[at])


def light_surface(colour, height, sheet):
    """Side light from the upper left on the paint's relief, with a faint oily gleam."""
    rise = gaussian_filter(height, 0.35 * sheet.scale)
    dy, dx = np.gradient(rise)
    slope = 0.62 * dx + 0.78 * dy
    shade = 1.0 + 0.95 * np.tanh(slope * 1.05)
    gleam = 0.05 * smoothstep(0.45, 1.1, slope)
    return colour * np.clip(shade, 0.3, 1.7)[..., None] + gleam[..., None] * np.array([1.0, 0.98, 0.93])


def paint(seed=1888):
    """The strip, linear light."""
    rng = np.random.default_rng(seed)
    sheet = Sheet()
    k = sheet.scale
    tile = (1024, 1024)
    streaks = 0.75 * noise(tile, rng, (0.42 * k, 16 * k)) + 0.6 * noise(tile, rng, (1.1 * k, 22 * k)) \
        + 0.25 * noise(tile, rng, (0.4 * k, 3 * k))
    banks = (Bank(streaks / streaks.std()), Bank(fractal(tile, rng, 1.5 * k, 2)))
    weave = canvas_weave(sheet, rng)
    value = tone_at(sheet.along())[None, :] * 0.9 + 0.02 + 0.03 * fractal(sheet.shape, rng, 6 * k)
    colour = mix(WARM.at(value), COOL.at(value), np.full(sheet.shape, 0.2))
    height = 0.25 * weave.astype(np.float32)
    count = 2600
    for turn in range(count):
        brush_stroke(colour, height, sheet, banks, weave, rng, turn / count)
    strip = sheet.scan(light_surface(colour, height, sheet))
    return settle(strip, hex_colour("ffffff"))
