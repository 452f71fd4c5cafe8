// Where an object's view-aligned texture lies on the screen (section 4.2), as core's methods::follow has it.
// Positions are device pixels, x right, y down.

import { Matrix3, Matrix4 } from 'three';

/// Vertices that stand for an object; more are represented by an even sample of them.
const maximumFollowed = 16384;

/// `count` vertices at most, three numbers each of positions and normals.
export function sampledVertices(positions, normals, count = maximumFollowed) {
    const stride = Math.ceil(positions.length / 3 / count);
    const kept = Math.ceil(positions.length / 3 / stride);
    const sampled = { positions: new Float32Array(kept * 3), normals: new Float32Array(kept * 3), count: kept };
    for (let i = 0; i < kept; ++i)
        for (let k = 0; k < 3; ++k) {
            sampled.positions[3 * i + k] = positions[3 * i * stride + k];
            sampled.normals[3 * i + k] = normals[3 * i * stride + k];
        }
    return sampled;
}

function transformed(m, p, i) {
    const [x, y, z] = [p[i], p[i + 1], p[i + 2]];
    return [m[0] * x + m[4] * y + m[8] * z + m[12], m[1] * x + m[5] * y + m[9] * z + m[13],
            m[2] * x + m[6] * y + m[10] * z + m[14], m[3] * x + m[7] * y + m[11] * z + m[15]];
}

function isInView([x, y, z, w]) {
    return w > 0 && Math.abs(x) <= w && Math.abs(y) <= w && Math.abs(z) <= w;
}

function screenPosition([x, y, , w], view) {
    return [(x / w * 0.5 + 0.5) * view.width, (-y / w * 0.5 + 0.5) * view.height];
}

/// Pixels an object-space unit takes at clip distance w.
function projectedScale(view, w) {
    const scale = Math.cbrt(Math.abs(new Matrix3().setFromMatrix4(view.objectToView).determinant()));
    return scale * view.projection.elements[5] * view.height * 0.5 / w;
}

function facingVertices(vertices, before, after) {
    const toView = before.objectToView.elements;
    const from = new Matrix4().multiplyMatrices(before.projection, before.objectToView).elements;
    const to = new Matrix4().multiplyMatrices(after.projection, after.objectToView).elements;
    const n = new Matrix3().getNormalMatrix(before.objectToView).elements;
    const unitBefore = projectedScale(before, 1), unitAfter = projectedScale(after, 1);
    const found = [];
    for (let i = 0; i < 3 * vertices.count; i += 3) {
        const clipFrom = transformed(from, vertices.positions, i);
        const clipTo = transformed(to, vertices.positions, i);
        if (!isInView(clipFrom) || !(clipTo[3] > 0)) continue;
        const eye = transformed(toView, vertices.positions, i);
        const [x, y, z] = [vertices.normals[i], vertices.normals[i + 1], vertices.normals[i + 2]];
        const nx = n[0] * x + n[3] * y + n[6] * z, ny = n[1] * x + n[4] * y + n[7] * z, nz = n[2] * x + n[5] * y + n[8] * z;
        const facing = -(nx * eye[0] + ny * eye[1] + nz * eye[2]) / (Math.hypot(nx, ny, nz) * Math.hypot(eye[0], eye[1], eye[2]));
        if (!(facing > 0)) continue;
        found.push({
            facing, from: screenPosition(clipFrom, before), to: screenPosition(clipTo, after),
            growth: unitAfter / clipTo[3] / (unitBefore / clipFrom[3]),
        });
    }
    return found;
}

/// The placement after an object moved from one view to the next; a view is {objectToView, projection, width,
/// height}.
export function follow(placement, vertices, before, after, followsZoom) {
    const found = facingVertices(vertices, before, after);
    if (found.length === 0) return placement;
    found.sort((a, b) => b.facing - a.facing);
    const tenth = Math.max(1, Math.floor(found.length / 10));
    const from = [0, 0], to = [0, 0];
    let growth = 0;
    for (const vertex of found.slice(0, tenth)) {
        for (const axis of [0, 1]) {
            from[axis] += vertex.from[axis] / tenth;
            to[axis] += vertex.to[axis] / tenth;
        }
        growth += Math.log(vertex.growth) / tenth;
    }
    const ratio = Math.exp(growth);
    const magnified = followsZoom ? ratio : 1;
    return { offset: [0, 1].map((axis) => to[axis] - (from[axis] - placement.offset[axis]) * magnified), zoom: placement.zoom * ratio };
}

/// The two octaves that a zoom cross-fades, as core's methods::zoomOctaves.
function zoomOctaves(zoom) {
    const fraction = Math.log2(zoom) - Math.floor(Math.log2(zoom));
    const faded = Math.min(Math.max(3 * fraction - 1, 0), 1);
    const norm = 1 / Math.hypot(faded, 1 - faded);
    return [{ scale: 2 ** -fraction, weight: (1 - faded) * norm }, { scale: 2 ** (1 - fraction), weight: faded * norm }];
}

/// An octave for the shader, which counts pixels upwards.
function placedOctave(offset, texelsPerPixel, size, height) {
    const factor = texelsPerPixel / size;
    const summands = [-offset[0] * factor, (height - offset[1]) * factor];
    const taps = texelsPerPixel <= 1 ? 1 : texelsPerPixel <= 2 ? 2 : 4;
    const step = taps === 1 ? 0 : (texelsPerPixel - 1) / (taps - 1) / size;
    return { texel: [factor, ...summands.map((value) => value - Math.floor(value)), step], taps };
}

/// What view_aligned.frag reads of an object's placement; `size` is a level's side.
export function shaderOctaves(placement, followsZoom, density, size, height) {
    const octaves = zoomOctaves(followsZoom ? placement.zoom : 1);
    const placed = octaves.map(({ scale }) => placedOctave(placement.offset, scale * density, size, height));
    return { texels: placed.map(({ texel }) => texel), weights: octaves.map(({ weight }) => weight), taps: placed.map(({ taps }) => taps) };
}
