# SPDX-License-Identifier: GPL-3.0-or-later
"""Pigments and palettes: how paints mix, after Kubelka and Munk's one-constant law."""
import numpy as np

from .sheet import hex_colour, luma


def absorb(reflectance):
    """K/S, absorption over scattering, of an opaque paint."""
    r = np.clip(reflectance, 0.004, 0.985)
    return (1.0 - r) ** 2 / (2.0 * r)


def reflect(ratio):
    """Reflectance of an opaque paint from its K/S."""
    return 1.0 + ratio - np.sqrt(ratio * ratio + 2.0 * ratio)


def mix(first, second, share):
    """Two opaque paints mixed, with the second's share 0..1."""
    share = np.asarray(share)[..., None]
    return reflect(absorb(first) * (1.0 - share) + absorb(second) * share)


class Palette:
    """Tube paints from dark to light, mixed neighbour with neighbour, looked up by lightness."""

    def __init__(self, *colours):
        paints = [hex_colour(c) for c in colours]
        share = np.linspace(0.0, 1.0, 64)
        table = np.concatenate([mix(a[None], b[None], share) for a, b in zip(paints, paints[1:])])
        value = np.maximum.accumulate(luma(table) + np.arange(len(table)) * 1e-6)
        self.values = np.linspace(value[0], value[-1], 512).astype(np.float32)
        self.colours = np.stack([np.interp(self.values, value, table[:, i]) for i in range(3)],
                                -1).astype(np.float32)

    def at(self, value):
        """The mixture of a lightness (sRGB luma); arrays give arrays of colours."""
        span = self.values[-1] - self.values[0]
        where = np.clip((np.asarray(value) - self.values[0]) / span, 0.0, 1.0) * 511.0
        return self.colours[np.rint(where).astype(int)]
