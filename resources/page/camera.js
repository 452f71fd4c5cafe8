// The studio's camera, which orbits a target; and the gestures that move it, by three.js.

import { MathUtils, PerspectiveCamera, Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

const degreesAKey = 5;
const glide = 0.992;  // what is left of a turn's speed after a millisecond
const steepest = 89.99;  // "up" needs to point somewhere

export class ViewCamera {
    /// `home` as in the scene: azimuth and elevation in degrees, distance in units of that from which the target
    /// sphere fills the free part of the picture. `before` may listen to the element first.
    constructor(home, element, before) {
        before(this);
        this.home = home;
        this.camera = new PerspectiveCamera();
        this.controls = new OrbitControls(this.camera, element);
        Object.assign(this.controls, { rotateSpeed: 0.8, zoomToCursor: true });
        this.controls.mouseButtons = { LEFT: 0, MIDDLE: 2, RIGHT: null };  // turn and pan; the right button is the light's
        element.addEventListener('keydown', (event) => this.#key(event));
        element.addEventListener('dblclick', () => this.goHome());
        this.goHome();
    }

    goHome() {
        const { target, radius, fieldOfView, distance } = this.home;
        this.controls.target.fromArray(target);
        this.#eyeDistance = distance * radius / Math.sin(MathUtils.degToRad(fieldOfView) / 2);
        this.controls.minDistance = 0.02 * this.#eyeDistance;
        this.controls.maxDistance = 12 * this.#eyeDistance;
        this.#look(this.home.azimuth, MathUtils.clamp(this.home.elevation, -steepest, steepest), this.#eyeDistance);
    }

    /// Fits the target sphere into what the panel leaves free at the top; all in CSS pixels.
    resize(width, height, panel) {
        const free = height - panel;
        const half = Math.min(width, free) / 2 / Math.tan(MathUtils.degToRad(this.home.fieldOfView) / 2);
        this.camera.aspect = width / height;
        this.camera.fov = MathUtils.radToDeg(2 * Math.atan(height / 2 / half));
        this.camera.setViewOffset(width, height, 0, panel / 2, width, height);
    }

    /// True when it moved since the last time; `time` is now, in ms.
    update(time) {
        // A turn runs out in the same time whatever the frame rate.
        this.controls.dampingFactor = 1 - glide ** Math.min(time - this.#time, 1000);
        this.#time = time;
        this.controls.update();
        const distance = this.camera.position.distanceTo(this.controls.target);
        const { radius } = this.home;
        this.camera.near = Math.max(distance * 0.01, distance - 20 * radius);
        this.camera.far = distance + 1000 * radius;
        this.camera.updateProjectionMatrix();
        this.camera.updateMatrixWorld();
        const pose = [...this.camera.matrixWorld.elements, ...this.camera.projectionMatrix.elements].join();
        const moved = pose !== this.#pose;
        this.#pose = pose;
        return moved;
    }

    /// Azimuth, elevation and distance as in the scene, and where it looks when that is another place than at home.
    get place() {
        const way = this.camera.position.clone().sub(this.controls.target);
        const distance = way.length();
        const place = [MathUtils.radToDeg(Math.atan2(way.x, way.z)), MathUtils.radToDeg(Math.asin(way.y / distance)),
                       distance / this.#eyeDistance * this.home.distance];
        const { target } = this.controls;
        return target.distanceTo(new Vector3(...this.home.target)) > 1e-6 * distance ? [...place, ...target.toArray()] : place;
    }

    set place([azimuth, elevation, distance, ...target]) {
        this.controls.target.fromArray(target.length === 3 ? target : this.home.target);
        this.#look(azimuth, MathUtils.clamp(elevation, -steepest, steepest), distance / this.home.distance * this.#eyeDistance);
    }

    /// Unit vectors in world space: right, up, and towards the eye.
    axes() {
        return [0, 1, 2].map((column) => new Vector3().setFromMatrixColumn(this.camera.matrixWorld, column));
    }

    #eyeDistance = 1;
    #pose = '';
    #time = 0;

    #look(azimuth, elevation, distance) {
        const [a, e] = [MathUtils.degToRad(azimuth), MathUtils.degToRad(elevation)];
        const back = new Vector3(Math.cos(e) * Math.sin(a), Math.sin(e), Math.cos(e) * Math.cos(a));
        this.controls.enableDamping = false;  // a turn that is still running out ends here
        this.controls.update();
        this.camera.position.copy(this.controls.target).addScaledVector(back, distance);
        this.controls.update();
        this.controls.enableDamping = true;
    }

    #key(event) {
        const turns = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
        if (event.key === 'Home') this.goHome();
        else if (turns) this.#turn(...turns);
        else return;
        event.preventDefault();
    }

    #turn(right, up) {
        const { target } = this.controls;
        const way = this.camera.position.clone().sub(target);
        const distance = way.length();
        const azimuth = MathUtils.radToDeg(Math.atan2(way.x, way.z)) + degreesAKey * right;
        const elevation = MathUtils.radToDeg(Math.asin(way.y / distance)) + degreesAKey * up;
        this.#look(azimuth, MathUtils.clamp(elevation, -steepest, steepest), distance);
    }
}
