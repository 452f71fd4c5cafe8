# SPDX-License-Identifier: GPL-3.0-or-later
"""The sheet that strips are painted on: geometry, noise, paper, and tone.

Lengths are in strip pixels (px) unless a name ends in _dots; a dot is one
pixel of the enlarged working canvas. Colours are linear light, 0..1.
"""
from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter, map_coordinates

LUMA = np.array([0.2126, 0.7152, 0.0722], np.float32)


@dataclass(frozen=True)
class Sheet:
    """A strip of width x height px, painted with a bleed all round that is cut off."""

    scale: int = 2
    width: int = 800
    height: int = 200
    bleed: int = 48

    @property
    def shape(self):
        """Rows and columns of the working canvas, in dots."""
        return ((self.height + 2 * self.bleed) * self.scale,
                (self.width + 2 * self.bleed) * self.scale)

    def along(self):
        """Position along the strip of each canvas column: 0 left border, 1 right border."""
        x = (np.arange(self.shape[1], dtype=np.float32) + 0.5) / self.scale - self.bleed
        return np.clip(x / self.width, 0.0, 1.0)

    def random_spot(self, rng):
        """A place anywhere on the canvas, bleed included: x, y in px from the strip's corner."""
        return (rng.uniform(-self.bleed, self.width + self.bleed),
                rng.uniform(-self.bleed, self.height + self.bleed))

    def part(self, x):
        """Where x (px) lies along the strip, 0..1."""
        return float(np.clip(x / self.width, 0.0, 1.0))

    def window(self, x, y, angle, reach, bend=0.0):
        """The canvas around (x, y) px: a slice pair and brush coordinates u, v in px.

        u runs along the stroke (angle in radians, y down), v across it; bend is
        the spine's curvature in 1/px. None where the window misses the canvas.
        """
        rows, columns = self.shape
        cx, cy, r = (x + self.bleed) * self.scale, (y + self.bleed) * self.scale, reach * self.scale
        x0, x1 = max(int(cx - r), 0), min(int(cx + r) + 1, columns)
        y0, y1 = max(int(cy - r), 0), min(int(cy + r) + 1, rows)
        if x0 >= x1 or y0 >= y1:
            return None
        dx = ((np.arange(x0, x1, dtype=np.float32) + 0.5) - cx) / self.scale
        dy = (((np.arange(y0, y1, dtype=np.float32) + 0.5) - cy) / self.scale)[:, None]
        c, s = np.float32(np.cos(angle)), np.float32(np.sin(angle))
        u = c * dx + s * dy
        v = c * dy - s * dx - np.float32(0.5 * bend) * u * u
        return (slice(y0, y1), slice(x0, x1)), u, v

    def scan(self, canvas, blur=0.32):
        """Cuts the bleed off and averages the dots of each px; blur is the lens's, in px."""
        canvas = gaussian_filter(canvas, (blur * self.scale, blur * self.scale, 0))
        b, k = self.bleed * self.scale, self.scale
        inner = canvas[b:b + self.height * k, b:b + self.width * k]
        return inner.reshape(self.height, k, self.width, k, -1).mean((1, 3))


def noise(shape, rng, sigma):
    """Smooth noise, zero mean and unit deviation; sigma in dots, one value or (y, x). Wraps."""
    field = gaussian_filter(rng.standard_normal(shape, dtype=np.float32), sigma, mode="wrap")
    return (field - field.mean()) / field.std()


def fractal(shape, rng, sigma, octaves=4, gain=0.6):
    """A sum of smooth noises, each half the size of the last; unit deviation."""
    total = sum(gain ** i * noise(shape, rng, sigma / 2 ** i) for i in range(octaves))
    return total / total.std()


class Bank:
    """A wrapping tile of noise from which every stroke takes a piece of its own."""

    def __init__(self, tile):
        self.tile = tile.astype(np.float32)

    def cut(self, shape, rng):
        """A piece of the tile at a random place."""
        r, c = rng.integers(self.tile.shape[0]), rng.integers(self.tile.shape[1])
        rows = (r + np.arange(shape[0])) % self.tile.shape[0]
        columns = (c + np.arange(shape[1])) % self.tile.shape[1]
        return self.tile[rows[:, None], columns]

    def sample(self, rows, columns, rng):
        """The tile at real coordinates (dots), from a random origin."""
        at = [rows + rng.integers(self.tile.shape[0]), columns + rng.integers(self.tile.shape[1])]
        return map_coordinates(self.tile, at, order=1, mode="grid-wrap", prefilter=False)


def smoothstep(low, high, x):
    """0 below low, 1 above high, smooth between."""
    t = np.clip((x - low) / (high - low), 0.0, 1.0)
    return t * t * (3.0 - 2.0 * t)


def paper_height(sheet, rng, grain=2.2, fibre=0.35, cloud=0.35):
    """Height of a paper's tooth, 0..1 with a flat histogram; grain in px.

    cloud is the share of unevenness wider than a grain.
    """
    g = grain * sheet.scale
    field = (noise(sheet.shape, rng, 0.42 * g) + 0.6 * noise(sheet.shape, rng, 0.8 * g)
             + cloud * noise(sheet.shape, rng, 1.9 * g))
    field += fibre * noise(sheet.shape, rng, (0.5 * g, 0.9 * g))
    return flatten(field)


def flatten(field):
    """The field's rank at each place, 0..1: a flat histogram."""
    spread = np.sort(field[::3, ::3].ravel())
    return (np.searchsorted(spread, field.ravel()) / spread.size).reshape(field.shape).astype(np.float32)


def relief(height, lift, light=(-0.6, -0.8)):
    """Side light on a surface: 1 where flat, more on slopes facing light, an (x, y) way to it."""
    dy, dx = np.gradient(height)
    return 1.0 - lift * (dx * light[0] + dy * light[1])


def encode(linear):
    """Linear light to sRGB values, 0..1."""
    x = np.clip(linear, 0.0, 1.0)
    return np.where(x <= 0.0031308, 12.92 * x, 1.055 * np.maximum(x, 1e-8) ** (1 / 2.4) - 0.055)


def decode(srgb):
    """sRGB values, 0..1, to linear light."""
    x = np.asarray(srgb, np.float32)
    return np.where(x <= 0.04045, x / 12.92, ((x + 0.055) / 1.055) ** 2.4).astype(np.float32)


def hex_colour(text):
    """Linear light of a colour written rrggbb."""
    return decode(np.array([int(text[i:i + 2], 16) for i in (0, 2, 4)]) / 255.0)


def luma(linear):
    """Lightness of a colour as sRGB luma, 0..1."""
    return encode(linear) @ LUMA


def tone_at(t, dark=0.10, light=0.915):
    """The lightness wanted at t (0..1) along a strip."""
    return dark + (light - dark) * t


def settle(strip, white, across=(6.0, 24.0), strength=0.85):
    """Evens a scanned strip's slow drift: more or less of the same paint, never a tint.

    The mean lightness of columns (over across[0] px) is brought to the wanted
    ramp, and that of places (over across[1] px) is first brought near it by
    strength, 0..1, by scaling the paint's optical density over white.
    """
    height, width = strip.shape[:2]
    wanted = tone_at((np.arange(width) + 0.5) / width)
    density = -np.log(np.clip(strip / white, 1e-4, 4.0))
    sigma_x, sigma_y = across
    for turn in range(14):
        value = luma(white * np.exp(-density))
        column = gaussian_filter(value.mean(0), sigma_x, mode="nearest")
        local = gaussian_filter(value, (sigma_y, sigma_y), mode="reflect")
        slow = column[None, :] + (strength if turn < 6 else 0.0) * (local - gaussian_filter(
            value.mean(0), sigma_y, mode="nearest")[None, :])
        wrong = np.log(np.clip(wanted, 0.01, 0.985)) / np.log(np.clip(slow, 0.01, 0.985))
        density *= wrong[..., None] ** 0.8
    return white * np.exp(-density)
