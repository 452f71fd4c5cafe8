#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sculpts the demo's meshes from signed distance fields.

    sculpt_meshes.py [-o DIR] [--preview DIR] [--quality Q] [skull still_life shell]

Needs numpy, scipy and scikit-image; Pillow too for the previews.
"""

import argparse
import pathlib
import sys
import time

from sculpt import shell, skull, still_life
from sculpt.polygonise import check
from sculpt.writers import write_glb, write_obj, write_ply

HERE = pathlib.Path(__file__).resolve().parent
VIEWS = [(0, 0), (35, 10), (90, 0), (40, -30)]


def make_skull(folder, quality):
    parts = skull.build(quality)
    write_glb(folder / "skull.glb", parts)
    return folder / "skull.glb", parts


def make_still_life(folder, quality):
    parts = still_life.build(quality)
    write_obj(folder / "still_life.obj", parts, "Chiaro demo still life, GPL-3.0-or-later")
    return folder / "still_life.obj", parts


def make_shell(folder, quality):
    mesh = shell.build(quality)
    write_ply(folder / "shell.ply", mesh, "Chiaro demo shell, GPL-3.0-or-later")
    return folder / "shell.ply", [("shell", mesh)]


MODELS = {"skull": make_skull, "still_life": make_still_life, "shell": make_shell}


def main():
    cli = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    cli.add_argument("names", nargs="*", metavar="name", help=f"any of: {', '.join(MODELS)}; default all")
    cli.add_argument("-o", "--output", type=pathlib.Path, default=HERE.parents[1] / "resources/demo/meshes")
    cli.add_argument("--preview", type=pathlib.Path, metavar="DIR", help="draw views of each as PNG into DIR")
    cli.add_argument("--quality", type=float, default=1.0, help="below 1 is coarser and quicker")
    args = cli.parse_args()
    unknown = set(args.names) - set(MODELS)
    if unknown:
        cli.error(f"no model called {', '.join(sorted(unknown))}")
    args.output.mkdir(parents=True, exist_ok=True)

    failed = False
    for name in args.names or MODELS:
        begun = time.time()
        path, parts = MODELS[name](args.output, args.quality)
        total = sum(len(mesh.faces) for _, mesh in parts)
        print(f"{path.name}: {total} triangles, {path.stat().st_size / 1e6:.2f} MB, {time.time() - begun:.0f} s")
        for part, mesh in parts:
            try:
                pieces = check(part, mesh)
                print(f"  {part}: {len(mesh.faces)} triangles, {len(mesh.vertices)} vertices, closed pieces: {pieces}")
            except AssertionError as fault:
                failed = True
                print(f"  BAD {fault}", file=sys.stderr)
        if args.preview:
            from sculpt.preview import sheet
            args.preview.mkdir(parents=True, exist_ok=True)
            sheet([mesh for _, mesh in parts], VIEWS, reach=1.3).save(args.preview / f"{name}.png")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
