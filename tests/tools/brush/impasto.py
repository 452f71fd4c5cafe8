# SPDX-License-Identifier: GPL-3.0-or-later
"""Palette-knife impasto: thick half-mixed slabs, dragged flat, with sharp ridges."""
import numpy as np
from scipy.ndimage import gaussian_filter

from .pigment import Palette, mix
from .sheet import Bank, Sheet, fractal, hex_colour, noise, settle, smoothstep, tone_at

# From blue-green night by viridian to cream; coral and earth are marbled in.
SEA = Palette("060f16", "0a2a33", "0f5157", "2f8078", "77aa93", "b8cfb0", "e6e5cc", "fbf8ee")
CORAL = Palette("160a12", "3d1522", "7a2a32", "b4524a", "d98a6c", "eab796", "f5dcc4", "fff4e8")


def knife_slab(colour, height, sheet, banks, rng, late):
    """One pull of the knife; late runs 0..1 over the painting, slabs getting smaller."""
    x, y = sheet.random_spot(rng)
    t = sheet.part(x)
    length = rng.uniform(20, 48) * (1.2 - 0.45 * late)
    width = rng.uniform(9, 20) * (1.15 - 0.5 * late)
    angle = rng.normal(-0.55, 0.55) + (np.pi if rng.random() < 0.5 else 0.0)
    found = sheet.window(x, y, angle, 0.5 * length + 0.5 * width + 4, rng.normal(0, 0.008))
    if found is None:
        return
    at, u, v = found
    streaks, lumps = banks
    k = sheet.scale
    run = u / length + 0.5
    skew = rng.normal(0, 0.35)                          # the blade rarely pulls square
    pull = streaks.sample(v * k, u * k, rng)
    marble = streaks.sample(v * k * 0.45, u * k * 0.8, rng)
    lump = lumps.cut(u.shape, rng)
    edge = 0.5 * width - np.abs(v) + 0.45 * pull + 0.3 * lump
    start = run * length + skew * v + 0.8 * lump
    stop = (1.0 - run) * length - skew * v + 1.6 * pull + 1.4 * lump
    shape = smoothstep(-0.3, 0.5, edge) * smoothstep(-0.3, 0.5, start) * smoothstep(-0.3, 0.7, stop)
    load = rng.uniform(0.5, 1.3) - 0.55 * np.clip(run, 0, 1) * rng.uniform(0.3, 1.4)
    cover = shape * smoothstep(-0.2, 0.25, load - 0.22 + 0.22 * pull + 0.25 * lump + 0.20 * height[at])
    value = (tone_at(t) + rng.normal(0, 0.04 + 0.05 * t * (1 - t)) + 0.035 * marble
             + 0.35 * (tone_at(sheet.along()[at[1]])[None, :] - tone_at(t)))
    warm = float(rng.choice([0.0, 0.15, 0.8], p=[0.62, 0.25, 0.13]))
    warm = np.clip(warm + 0.28 * (marble > rng.uniform(0.6, 1.8)) + 0.05 * pull, 0, 1)
    colour[at] += cover[..., None] * (mix(SEA.at(value), CORAL.at(value), warm) - colour[at])
    lip = 1.1 * np.exp(-(edge / 0.8) ** 2) + 1.3 * np.exp(-((stop - 1.2) / 1.2) ** 2)
    slab = 0.75 * load + 0.10 * pull + 0.12 * lump + lip * rng.uniform(0.3, 1.0) \
        + rng.normal(0, 0.5) * v / width
    height[at] += cover * (slab - 0.8 * height[at])


def light_surface(colour, height, sheet):
    """Side light from the upper left, short cast shade, and a gleam on the ridges."""
    rise = gaussian_filter(height, 0.38 * sheet.scale)
    dy, dx = np.gradient(rise)
    slope = 0.6 * dx + 0.8 * dy
    reach = np.roll(rise, (2 * sheet.scale, int(1.5 * sheet.scale)), (0, 1))
    shadow = 1.0 - 0.22 * smoothstep(0.15, 1.0, reach - rise)
    shade = (1.0 + 0.9 * np.tanh(0.95 * slope)) * shadow
    gleam = 0.06 * smoothstep(0.4, 1.1, slope)
    return colour * np.clip(shade, 0.3, 1.75)[..., None] + gleam[..., None]


def paint(seed=1951):
    """The strip, linear light."""
    rng = np.random.default_rng(seed)
    sheet = Sheet()
    k = sheet.scale
    tile = (1024, 1024)
    streaks = noise(tile, rng, (0.5 * k, 20 * k)) + 0.8 * noise(tile, rng, (1.5 * k, 26 * k))
    banks = (Bank(streaks / streaks.std()), Bank(fractal(tile, rng, 4 * k, 4, 0.7)))
    value = tone_at(sheet.along())[None, :] + 0.03 * fractal(sheet.shape, rng, 6 * k)
    colour = mix(SEA.at(value), CORAL.at(value), np.full(sheet.shape, 0.35))
    height = 0.2 * fractal(sheet.shape, rng, 3 * k)
    count = 1900
    for turn in range(count):
        knife_slab(colour, height, sheet, banks, rng, turn / count)
    return settle(sheet.scan(light_surface(colour, height, sheet)), hex_colour("ffffff"))
