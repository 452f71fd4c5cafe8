// The scene's objects with their paint, for three.js. Colours are display-referred values all the way: nothing
// here converts them.

import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { inflated, picture } from './payload.js';
import { follow, sampledVertices, shaderOctaves } from './placement.js';
import pageVert from './shaders/page.vert';
import viewAlignedFrag from './shaders/view_aligned.frag';
import viewDependentFrag from './shaders/view_dependent.frag';

const tableWidth = 2048;  // as in view_dependent.frag
const followedInAll = 65536;

/// A row of `width` colours, RGB in 16 bits each.
function gradientTexture(values) {
    const count = values.length / 3, halves = new Uint16Array(4 * count);
    for (let i = 0; i < count; ++i)
        for (let k = 0; k < 4; ++k) halves[4 * i + k] = THREE.DataUtils.toHalfFloat(k < 3 ? values[3 * i + k] / 65535 : 1);
    const texture = new THREE.DataTexture(halves, count, 1, THREE.RGBAFormat, THREE.HalfFloatType);
    texture.minFilter = texture.magFilter = THREE.LinearFilter;
    texture.needsUpdate = true;
    return texture;
}

/// Slices of a 3D texture, uploaded one by one so that no copy of the whole is ever made.
async function sliceTexture(renderer, { width, height, images }, wrap) {
    const texture = new THREE.Data3DTexture(null, width, height, images.length);
    texture.minFilter = texture.magFilter = THREE.LinearFilter;
    texture.wrapS = texture.wrapT = wrap;
    texture.source.dataReady = false;
    texture.needsUpdate = true;
    renderer.initTexture(texture);
    for (let i = 0; i < images.length; ++i) {
        const slice = new THREE.Texture(await picture(images[i]));
        renderer.copyTextureToTexture(slice, texture, null, new THREE.Vector3(0, 0, i));
        slice.image.close();
    }
    return texture;
}

/// Numbers by index, `channels` each, in rows that the shader knows the width of.
function tableTexture(data, channels, format, type, internalFormat) {
    const height = Math.max(1, Math.ceil(data.length / channels / tableWidth));
    const padded = new data.constructor(tableWidth * height * channels);
    padded.set(data);
    const texture = new THREE.DataTexture(padded, tableWidth, height, format, type);
    texture.internalFormat = internalFormat;
    texture.unpackAlignment = 1;
    texture.needsUpdate = true;
    return texture;
}

/// An object's face tables: how many views each face has, then each entry's view, then its weights at the
/// face's three corners, one after the other.
function faceTables(buffer, faceCount) {
    const counts = new Uint16Array(buffer, 0, faceCount);
    const ranges = new Uint32Array(2 * faceCount);
    let total = 0;
    for (let face = 0; face < faceCount; ++face) {
        ranges.set([total, counts[face]], 2 * face);
        total += counts[face];
    }
    const views = new Uint16Array(buffer, 2 * faceCount, total);
    const corners = new Uint8Array(buffer, 2 * (faceCount + total));
    const entries = new Uint16Array(4 * total);
    for (let i = 0; i < total; ++i)
        entries.set([views[i], corners[i], corners[total + i], corners[2 * total + i]], 4 * i);
    return {
        faceViews: tableTexture(ranges, 2, THREE.RGIntegerFormat, THREE.UnsignedIntType, 'RG32UI'),
        weights: tableTexture(entries, 4, THREE.RGBAIntegerFormat, THREE.UnsignedShortType, 'RGBA16UI'),
    };
}

async function objectTextures(renderer, textures) {
    const views = new THREE.DataTexture(new Float32Array(textures.views), 4, textures.views.length / 16, THREE.RGBAFormat, THREE.FloatType);
    views.needsUpdate = true;
    return {
        ...textures, ...faceTables(await inflated(textures.faces), textures.faceCount), views,
        texels: await sliceTexture(renderer, textures, THREE.ClampToEdgeWrapping),
    };
}

export class Painter {
    /// Reads everything; `told` hears how far it is, in [0, 1].
    static async make(renderer, scene, lights, told) {
        const painter = new Painter();
        painter.renderer = renderer;
        painter.source = scene;
        const works = 1 + scene.paints.length + scene.textures.length;
        let done = 0;
        const step = async (work) => {
            const result = await work;
            told(++done / works);
            await new Promise((resolve) => setTimeout(resolve));  // lets the page be drawn
            return result;
        };
        const meshes = await step(readMeshes(await inflated(scene.mesh)));
        painter.paints = [];
        for (const paint of scene.paints) {
            painter.paints.push(await step((async () => ({
                ...paint, colors: new Uint16Array(await inflated(paint.gradient)),
                levels: { ...paint.levels, texture: await sliceTexture(renderer, { width: paint.levels.size, height: paint.levels.size, images: paint.levels.images }, THREE.RepeatWrapping) },
            }))()));
        }
        painter.textures = [];
        for (const textures of scene.textures) painter.textures.push(await step(objectTextures(renderer, textures)));
        painter.#build(meshes, lights);
        return painter;
    }

    scene = new THREE.Scene();

    #build(meshes, lights) {
        const perObject = Math.min(16384, Math.ceil(followedInAll / meshes.length));
        this.gradients = this.paints.map(({ colors }) => gradientTexture(colors));
        this.objects = meshes.map((mesh, i) => {
            const { position, normal } = mesh.geometry.attributes;
            const vertices = sampledVertices(position.array, normal.array, perObject);
            mesh.geometry = mesh.geometry.index ? mesh.geometry.toNonIndexed() : mesh.geometry;
            mesh.geometry.computeBoundingSphere();
            mesh.geometry.addGroup(0, Infinity, 0);
            mesh.geometry.addGroup(0, Infinity, 1);
            mesh.matrixAutoUpdate = false;
            mesh.updateMatrix();
            mesh.updateMatrixWorld(true);
            this.scene.add(mesh);
            const object = { mesh, vertices, paint: this.source.objects[i].paint, placement: { offset: [0, 0], zoom: 1 }, seen: null };
            const textures = this.textures[this.source.objects[i].textures];
            const shared = {
                ...lights.uniforms, gradient: { value: null }, gradientSpan: { value: new THREE.Vector2() },
                normalToWorld: { value: new THREE.Matrix3().getNormalMatrix(mesh.matrixWorld) }, middle: { value: new THREE.Vector3(...(textures?.middle ?? [0, 0, 0])) },
            };
            object.shared = shared;
            object.materials = { 'view-aligned': this.#aligned(object, lights), 'view-dependent': this.#dependent(object, textures, lights) };
            return object;
        });
        this.useGradient(null);
    }

    /// For fronts and for backs. These stand back a little: at a silhouette, where both lie in one place, the light
    /// of a back would fringe the object.
    #materials(object, lights, fragmentShader, own, defines = {}) {
        const uniforms = { ...object.shared, ...own };
        return [THREE.FrontSide, THREE.BackSide].map((side) => Object.assign(new THREE.RawShaderMaterial({
            glslVersion: THREE.GLSL3, side, vertexShader: pageVert, fragmentShader, defines: { ...lights.defines, ...defines },
            polygonOffset: side === THREE.BackSide, polygonOffsetFactor: 1, polygonOffsetUnits: 2,
        }), { uniforms }));
    }

    #aligned(object, lights) {
        const { levels } = this.paints[object.paint];
        return this.#materials(object, lights, viewAlignedFrag, {
            levels: { value: levels.texture }, levelRange: { value: new THREE.Vector2(levels.factor, levels.bias) },
            octaves: { value: [new THREE.Vector4(), new THREE.Vector4()] }, octaveWeights: { value: new THREE.Vector2() }, octaveTaps: { value: [1, 1] },
        });
    }

    #dependent(object, textures, lights) {
        if (!textures) return this.#materials(object, lights, viewDependentFrag, {}, { TEXTURED: 0, PRESERVING: 0 });
        const end = 0.5 / textures.levelCount;
        return this.#materials(object, lights, viewDependentFrag, {
            faceViews: { value: textures.faceViews }, weights: { value: textures.weights }, views: { value: textures.views },
            texels: { value: textures.texels }, texelRange: { value: new THREE.Vector2(textures.factor, textures.bias) },
            levelEnds: { value: new THREE.Vector2(end, 1 - end) }, eye: { value: new THREE.Vector3() },
        }, {
            TEXTURED: 1, PERSPECTIVE: Number(textures.perspective), FOLLOW_CAMERA: Number(this.source.followCamera),
            PRESERVING: Number(this.source.preserving), PAGES: textures.pageCount,
        });
    }

    useMethod(method) {
        for (const { mesh, materials } of this.objects) mesh.material = materials[method];
    }

    /// Colours (RGB, 16 bits each) for all objects, or null for each its own.
    useGradient(colors) {
        const texture = colors && gradientTexture(colors);
        for (const { shared, paint } of this.objects) {
            shared.gradient.value = texture ?? this.gradients[paint];
            const width = shared.gradient.value.image.width;
            shared.gradientSpan.value.set((width - 1) / width, 0.5 / width);
        }
    }

    /// Draws a frame; textures follow the objects to where this camera shows them.
    draw(camera) {
        const size = this.renderer.getDrawingBufferSize(new THREE.Vector2());
        for (const object of this.objects) {
            const now = {
                objectToView: new THREE.Matrix4().multiplyMatrices(camera.matrixWorldInverse, object.mesh.matrixWorld),
                projection: camera.projectionMatrix.clone(), width: size.x, height: size.y,
            };
            this.#follow(object, now);
            const { octaves, octaveWeights, octaveTaps } = object.materials['view-aligned'][0].uniforms;
            const shown = shaderOctaves(object.placement, this.source.followZoom, this.source.density, this.paints[object.paint].levels.size, size.y);
            shown.texels.forEach((texel, i) => octaves.value[i].fromArray(texel));
            octaveWeights.value.fromArray(shown.weights);
            octaveTaps.value = shown.taps;
            const { eye } = object.materials['view-dependent'][0].uniforms;
            eye?.value.copy(camera.position).applyMatrix4(object.mesh.matrixWorld.clone().invert()).sub(object.shared.middle.value);
        }
        this.renderer.render(this.scene, camera);
    }

    #follow(object, now) {
        const before = object.seen;
        object.seen = now;
        if (!before) return;
        // A window of another size shows the object elsewhere, its strokes as large as before.
        const resized = { ...before, projection: now.projection, width: now.width, height: now.height };
        if (before.width !== now.width || before.height !== now.height)
            object.placement.offset = follow(object.placement, object.vertices, before, resized, false).offset;
        if (!resized.objectToView.equals(now.objectToView))
            object.placement = follow(object.placement, object.vertices, resized, now, this.source.followZoom);
    }
}

async function readMeshes(bytes) {
    const model = await new GLTFLoader().parseAsync(bytes, '');
    return model.scene.children.slice();
}
