# SPDX-License-Identifier: GPL-3.0-or-later
"""Soft pastel: opaque, crumbling colour caught by the tooth of a toned paper."""
import numpy as np

from .charcoal import smudge
from .pigment import Palette, mix
from .sheet import (Bank, Sheet, fractal, hex_colour, noise, paper_height, relief, settle,
                    smoothstep, tone_at)

# The sticks in the box: deep violet by mauve and clay to ochre and pale rose,
# and the sea blues and greys that are broken into them.
EARTH = Palette("120c26", "35214f", "6d4468", "a0645f", "c4935a", "dcb886", "f2d6c9", "fff6f0")
CHILL = Palette("091424", "16304e", "335c7c", "64859a", "94a9b4", "bfc6c4", "e2dde4", "fbf8f6")
TONED_PAPER = "8c7a6e"


def drag_stick(colour, dust, sheet, streaks, tooth, rng, width, firm, softness=0.17):
    """One stroke of a stick, width px wide; firm is its pressure, 0..1.

    softness is how far (in tooth heights) the stick gives way.
    """
    x, y = sheet.random_spot(rng)
    t = sheet.part(x)
    length = rng.uniform(18, 52) * (1.15 - 0.35 * t)
    angle = rng.normal(-0.75, 0.22) + (1.35 if rng.random() < 0.06 else 0.0)
    found = sheet.window(x, y, angle, 0.5 * length + width, rng.normal(0, 0.01))
    if found is None:
        return
    at, u, v = found
    k = sheet.scale
    line = streaks.sample(v * k, u * k, rng)
    crumb = streaks.sample(v * k * 2.2, u * k * 4.0, rng)
    across = smoothstep(-0.1, 1.0, (0.5 * width - np.abs(v)) / (0.12 * width + 0.6) + 0.3 * line)
    ends = smoothstep(0.0, 0.25, 1.0 - np.abs(u) / (0.5 * length) + 0.07 * line)
    contact = firm * across * ends * (1.0 + 0.28 * line + 0.10 * crumb)
    met = smoothstep(-softness, softness, tooth[at] + 1.1 * contact - 1.0)
    left = met * (0.65 + 0.35 * np.clip(contact, 0, 1))
    value = (tone_at(t) + rng.normal(0, 0.036) + 0.5 * (tone_at(sheet.along()[at[1]])[None, :] - tone_at(t))
             + 0.012 * crumb)
    cool = float(rng.choice([0.0, 0.12, 0.85], p=[0.55, 0.25, 0.20]))
    stick = mix(EARTH.at(value), CHILL.at(value), np.full(u.shape, cool))
    colour[at] += left[..., None] * (stick - colour[at])
    dust[at] += 0.5 * left * (contact - dust[at])


def blend(colour, sheet, rng, clouds):
    """A finger's soft drag through the colours."""
    state = rng.bit_generator.state
    for channel in range(3):                            # the same finger through each channel
        rng.bit_generator.state = state
        layer = np.ascontiguousarray(colour[..., channel])
        smudge(layer, sheet, rng, clouds, rng.normal(-0.75, 0.3))
        colour[..., channel] = layer


def paint(seed=1876):
    """The strip, linear light."""
    rng = np.random.default_rng(seed)
    sheet = Sheet()
    k = sheet.scale
    tooth = paper_height(sheet, rng, grain=1.7, fibre=0.4, cloud=0.15)
    tile = (1024, 1024)
    streaks = noise(tile, rng, (0.5 * k, 14 * k)) + 0.6 * noise(tile, rng, (1.5 * k, 24 * k))
    streaks = Bank(streaks / streaks.std())
    clouds = Bank(fractal(tile, rng, 5 * k, 3))
    colour = np.ones(sheet.shape + (3,), np.float32) * hex_colour(TONED_PAPER)
    value = tone_at(sheet.along())[None, :] + 0.03 * fractal(sheet.shape, rng, 4 * k, 3)
    powder = 0.97 - 0.08 * sheet.along() - 0.22 * (1 - tooth) + 0.05 * clouds.cut(sheet.shape, rng)
    powder = np.clip(powder, 0, 1)[..., None]
    cool = np.clip(0.3 + 0.3 * clouds.cut(sheet.shape, rng), 0, 1)
    colour += powder * (mix(EARTH.at(value), CHILL.at(value), cool) - colour)  # rubbed in with a rag
    dust = np.zeros(sheet.shape, np.float32)
    for _ in range(1100):
        drag_stick(colour, dust, sheet, streaks, tooth, rng, rng.uniform(9, 20), rng.uniform(0.8, 1.1),
                   softness=0.5)
    for _ in range(420):
        blend(colour, sheet, rng, clouds)
    for _ in range(1300):
        drag_stick(colour, dust, sheet, streaks, tooth, rng, rng.uniform(4, 12), rng.uniform(0.3, 0.75))
    for _ in range(900):
        drag_stick(colour, dust, sheet, streaks, tooth, rng, rng.uniform(1.8, 4), rng.uniform(0.35, 0.85))
    surface = 0.7 * tooth + 0.8 * dust
    colour *= relief(surface, 0.22)[..., None]
    return settle(sheet.scan(colour), hex_colour("ffffff"))
