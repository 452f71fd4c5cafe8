# SPDX-License-Identifier: GPL-3.0-or-later
"""GLB, OBJ and PLY files from named meshes."""

import json
import struct

import numpy as np


def write_glb(path, parts):
    """Binary glTF 2.0: one node and one mesh per named part."""
    blob = bytearray()
    views, accessors, meshes, nodes = [], [], [], []

    def add(data, target, component, kind, **extra):
        while len(blob) % 4:
            blob.append(0)
        raw = data.tobytes()
        views.append({"buffer": 0, "byteOffset": len(blob), "byteLength": len(raw), "target": target})
        blob.extend(raw)
        accessors.append({"bufferView": len(views) - 1, "componentType": component,
                          "count": len(data) if kind != "SCALAR" else data.size, "type": kind, **extra})
        return len(accessors) - 1

    for name, mesh in parts:
        v = mesh.vertices.astype("<f4")
        n = mesh.normals / np.linalg.norm(mesh.normals, axis=1)[:, None]
        position = add(v, 34962, 5126, "VEC3", min=[float(x) for x in v.min(axis=0)],
                       max=[float(x) for x in v.max(axis=0)])
        normal = add(n.astype("<f4"), 34962, 5126, "VEC3")
        short = len(v) < 65535
        index = add(mesh.faces.astype("<u2" if short else "<u4").ravel(), 34963,
                    5123 if short else 5125, "SCALAR")
        meshes.append({"name": name, "primitives": [
            {"attributes": {"POSITION": position, "NORMAL": normal}, "indices": index, "mode": 4}]})
        nodes.append({"name": name, "mesh": len(meshes) - 1})
    while len(blob) % 4:
        blob.append(0)
    head = {"asset": {"version": "2.0", "generator": "Chiaro sculpt_meshes.py"}, "scene": 0,
            "scenes": [{"nodes": list(range(len(nodes)))}], "nodes": nodes, "meshes": meshes,
            "accessors": accessors, "bufferViews": views, "buffers": [{"byteLength": len(blob)}]}
    text = json.dumps(head, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    with open(path, "wb") as out:
        out.write(struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + len(blob)))
        out.write(struct.pack("<I4s", len(text), b"JSON") + text)
        out.write(struct.pack("<I4s", len(blob), b"BIN\0") + bytes(blob))


def write_obj(path, parts, title):
    """Wavefront OBJ: one `o` per named part, with normals, one index for both."""
    base = 1
    with open(path, "w", encoding="ascii", newline="\n") as out:
        out.write(f"# {title}\n")
        for name, mesh in parts:
            out.write(f"o {name}\n")
            out.write("".join("v %.5g %.5g %.5g\n" % tuple(r) for r in mesh.vertices))
            out.write("".join("vn %.3f %.3f %.3f\n" % tuple(r) for r in mesh.normals))
            out.write("s 1\n")
            out.write("".join("f %d//%d %d//%d %d//%d\n" % (a, a, b, b, c, c)
                              for a, b, c in (mesh.faces + base).tolist()))
            base += len(mesh.vertices)


def write_ply(path, mesh, comment):
    """Binary little-endian PLY with normals."""
    vertices = np.hstack([mesh.vertices, mesh.normals]).astype("<f4")
    faces = np.zeros(len(mesh.faces), dtype=[("n", "u1"), ("i", "<i4", 3)])
    faces["n"], faces["i"] = 3, mesh.faces
    head = ("ply\nformat binary_little_endian 1.0\n" f"comment {comment}\n"
            f"element vertex {len(vertices)}\n"
            + "".join(f"property float {c}\n" for c in ("x", "y", "z", "nx", "ny", "nz"))
            + f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
    with open(path, "wb") as out:
        out.write(head.encode() + vertices.tobytes() + faces.tobytes())
