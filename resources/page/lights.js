// The lights of the scene as core's scene::lightValue has them, and turning the first of them.

import { Vector2, Vector3, Vector4 } from 'three';

const degreesAPixel = 0.5;

export class Lights {
    constructor(lights) {
        this.list = lights.map((light) => ({ ...light, vector: new Vector3(...light.vector) }));
        this.hard = this.list.filter((light) => light.kind === 'directional' && !light.wrap);
        this.points = this.list.filter((light) => light.kind === 'point');
        /// Compiled into the shaders.
        this.defines = { HARD_LIGHTS: this.hard.length, POINT_LIGHTS: this.points.length };
        /// Shared by all shaders.
        this.uniforms = {
            wrappedLight: { value: new Vector4() },
            hardLights: { value: this.hard.map(() => new Vector3()) },
            pointLights: { value: this.points.map((light) => light.vector) },
            pointShine: { value: this.points.map(({ intensity, wrap }) => wrap ? new Vector2(intensity / 2, intensity / 2) : new Vector2(0, intensity)) },
        };
        this.update();
    }

    get turned() { return this.list[0]; }

    /// What the shaders read, after a light was turned.
    update() {
        const sum = this.uniforms.wrappedLight.value.set(0, 0, 0, 0);
        for (const { kind, wrap, intensity, vector } of this.list) {
            if (kind !== 'directional' || !wrap) continue;
            const half = vector.clone().normalize().multiplyScalar(intensity / 2);
            sum.add(new Vector4(half.x, half.y, half.z, intensity / 2));
        }
        this.hard.forEach(({ vector, intensity }, i) => this.uniforms.hardLights.value[i].copy(vector).normalize().multiplyScalar(intensity));
    }

    /// L at a place with a unit normal, for the ball.
    value(position, normal) {
        let sum = 0;
        for (const { kind, wrap, intensity, vector } of this.list) {
            const way = kind === 'point' ? vector.clone().sub(position) : vector.clone();
            const cosine = normal.dot(way.normalize());
            sum += intensity * (wrap ? 0.5 + 0.5 * cosine : Math.max(cosine, 0));
        }
        return Math.min(Math.max(sum, 0), 1);
    }

    /// The way from the middle of the scene to the turned light, and back to where it then stands.
    #wayFrom(target) { return this.turned.kind === 'point' ? this.turned.vector.clone().sub(target) : this.turned.vector.clone(); }
    #place(way, target) {
        this.turned.vector.copy(way);
        if (this.turned.kind === 'point') this.turned.vector.add(target);
        this.update();
    }

    /// Lets it shine from a direction, or stand at a place.
    put(vector) {
        this.turned?.vector.fromArray(vector);
        this.update();
    }

    /// Turns it so that the lit side follows a drag of so many pixels.
    drag(dx, dy, [right, up], target) {
        const radians = degreesAPixel * Math.PI / 180;
        this.#place(this.#wayFrom(target).applyAxisAngle(up, radians * dx).applyAxisAngle(right, radians * dy), target);
    }

    /// Lets it shine on a place of a ball of radius 1 seen from the eye; beyond its rim it goes behind.
    aim(x, y, [right, up, back], target) {
        const length = Math.hypot(x, y);
        const behind = length > 1;
        const scale = behind ? Math.max(0, 2 - length) / length : 1;
        const z = Math.sqrt(Math.max(0, 1 - (x * x + y * y) * scale * scale)) * (behind ? -1 : 1);
        const way = new Vector3().addScaledVector(right, x * scale).addScaledVector(up, y * scale).addScaledVector(back, z);
        this.#place(way.multiplyScalar(this.#wayFrom(target).length()), target);
    }
}

/// Draws a ball lit as the scene and painted with `colors` (bytes, RGB) onto a canvas.
export function drawBall(canvas, lights, colors, [right, up, back], target, radius) {
    const context = canvas.getContext('2d');
    const side = canvas.width, image = context.createImageData(side, side), half = side / 2;
    const count = colors.length / 3;
    const normal = new Vector3(), place = new Vector3();
    for (let y = 0; y < side; ++y)
        for (let x = 0; x < side; ++x) {
            const px = (x + 0.5 - half) / half, py = (half - y - 0.5) / half, length = Math.hypot(px, py);
            const coverage = Math.min(Math.max((1 - length) * half, 0), 1);
            if (coverage === 0) continue;
            normal.set(0, 0, 0).addScaledVector(right, px).addScaledVector(up, py).addScaledVector(back, Math.sqrt(Math.max(0, 1 - length * length)));
            const light = lights.value(place.copy(target).addScaledVector(normal, radius), normal.normalize());
            const entry = 3 * Math.round(light * (count - 1));
            image.data.set([colors[entry], colors[entry + 1], colors[entry + 2], 255 * coverage], 4 * (y * side + x));
        }
    context.putImageData(image, 0, 0);
}
