#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Paints the built-in demo's strips of paint: python3 paint_strips.py [-o DIR] [names...]

Needs numpy, scipy and Pillow. The same names give the same pictures every time.
"""
import argparse
import importlib
from pathlib import Path

import numpy as np
from PIL import Image

from brush.sheet import encode

NAMES = ("watercolour", "oil", "charcoal", "hatching", "pastel", "impasto")
SAMPLES = Path(__file__).resolve().parents[2] / "resources" / "demo" / "samples"


def save(strip, path):
    """Writes linear light as an 8-bit sRGB PNG, rounded with a fixed fine dither."""
    dither = np.random.default_rng(7).uniform(-0.5, 0.5, strip.shape[:2])[..., None]
    values = np.clip(np.rint(encode(strip) * 255.0 + dither), 0, 255).astype(np.uint8)
    Image.fromarray(values).save(path, optimize=True)


def main():
    parser = argparse.ArgumentParser(description="Paints the demo's strips of paint.")
    parser.add_argument("-o", "--output", type=Path, default=SAMPLES, metavar="DIR",
                        help="folder to write into (default: the project's demo samples)")
    parser.add_argument("names", nargs="*", metavar="names",
                        help="strips to paint: " + ", ".join(NAMES) + " (default: all)")
    arguments = parser.parse_args()
    unknown = [name for name in arguments.names if name not in NAMES]
    if unknown:
        parser.error("no such strip: " + ", ".join(unknown))
    arguments.output.mkdir(parents=True, exist_ok=True)
    for name in arguments.names or NAMES:
        strip = importlib.import_module("brush." + name).paint()
        path = arguments.output / (name + ".png")
        save(strip, path)
        print(path)


if __name__ == "__main__":
    main()
