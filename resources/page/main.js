// The relightable page. After the # of its address stands what is shown, so that a copied address shows the same:
// method, gradient (a preset's name), light (x,y,z), camera (azimuth, elevation, distance and what it looks at),
// and, if only the picture is wanted, ui=off.

import { ColorManagement, LinearSRGBColorSpace, WebGLRenderer } from 'three';
import { ViewCamera } from './camera.js';
import { Lights, drawBall } from './lights.js';
import { Painter } from './painter.js';
import { gradientBars, methodSwitch } from './panel.js';
import { scene } from './payload.js';

const element = (id) => document.getElementById(id);
const sharpest = 2;  // device pixels a CSS pixel; more only costs time
const addressEvery = 400;  // ms

function settings() {
    const found = new URLSearchParams(location.hash.slice(1));
    const numbers = (name, ...counts) => {
        const values = (found.get(name) ?? '').split(',').map(Number);
        return counts.includes(values.length) && values.every(Number.isFinite) ? values : null;
    };
    const light = numbers('light', 3), camera = numbers('camera', 3, 6);
    return { method: found.get('method'), gradient: found.get('gradient'), isBare: found.get('ui') === 'off',
             light: light && Math.hypot(...light) > 0 ? light : null, camera: camera && camera[2] > 0 ? camera : null };
}

function tell(state, text) {
    document.documentElement.dataset.state = state;
    element('message').textContent = text;
}

function makeRenderer() {
    ColorManagement.enabled = false;
    const renderer = new WebGLRenderer({ canvas: element('picture'), antialias: true, alpha: true });
    renderer.outputColorSpace = LinearSRGBColorSpace;  // what a shader writes is what is shown
    renderer.setClearColor(0, 0);
    return renderer;
}

/// Shift-drag and right-drag turn the light, anywhere in the picture.
function dragLight(canvas, view, lights, changed) {
    const isOurs = (event) => lights.turned && event.isPrimary && (event.button === 2 || (event.button === 0 && event.shiftKey));
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('pointerdown', (event) => {
        if (!isOurs(event)) return;
        event.stopImmediatePropagation();  // not the camera's as well
        canvas.setPointerCapture(event.pointerId);
        canvas.classList.add('light');
        let [x, y] = [event.clientX, event.clientY];
        const move = (to) => {
            lights.drag(to.clientX - x, to.clientY - y, view.axes(), view.controls.target);
            [x, y] = [to.clientX, to.clientY];
            changed();
        };
        canvas.addEventListener('pointermove', move);
        canvas.addEventListener('lostpointercapture', () => {
            canvas.removeEventListener('pointermove', move);
            canvas.classList.remove('light');
        }, { once: true });
    }, { capture: true });
}

function dragBall(ball, view, lights, changed) {
    const aim = (event) => {
        const { left, top, width, height } = ball.getBoundingClientRect();
        lights.aim((event.clientX - left) / width * 2 - 1, 1 - (event.clientY - top) / height * 2, view.axes(), view.controls.target);
        changed();
    };
    ball.addEventListener('pointerdown', (event) => {
        ball.setPointerCapture(event.pointerId);
        aim(event);
    });
    ball.addEventListener('pointermove', (event) => ball.hasPointerCapture(event.pointerId) && aim(event));
}

function showHint() {
    const touch = matchMedia('(pointer: coarse)').matches;
    element('hint').textContent = touch ? 'Drag to turn · pinch to come closer · the ball is the light'
                                        : 'Drag to turn · scroll to come closer · Shift-drag or the ball turns the light';
    addEventListener('pointerdown', () => element('hint').classList.add('done'), { once: true, capture: true });
}

function colorsOf(hex) {
    return Uint16Array.from(hex.match(/../g), (byte) => parseInt(byte, 16) * 257);
}

function makeChoices(painter, shown, changed) {
    const chooseMethod = methodSwitch(element('methods'), (method) => {
        shown.method = method;
        painter.useMethod(method);
        changed();
    });
    const presets = scene.presets.map(({ name, colors }) => ({ name, colors: colorsOf(colors) }));
    const chooseGradient = gradientBars(element('gradients'), painter.paints.map(({ colors }) => colors), presets, (name, colors) => {
        shown.gradient = name;
        shown.colors = Uint8Array.from(colors ?? painter.paints[0].colors, (value) => value / 257 + 0.5);
        painter.useGradient(colors);
        changed();
    });
    return { chooseMethod, chooseGradient };
}

function fit(renderer, view) {
    const isBare = document.documentElement.dataset.ui === 'off';
    const panel = isBare ? 0 : innerHeight - element('panel').getBoundingClientRect().top;
    document.documentElement.style.setProperty('--panel', `${panel}px`);
    renderer.setPixelRatio(Math.min(devicePixelRatio, sharpest));
    renderer.setSize(innerWidth, innerHeight, false);
    view.resize(innerWidth, innerHeight, panel);
}

/// Puts what is shown into the address.
function tellAddress(shown, lights, view) {
    const written = (values) => values.map((value) => +value.toFixed(4)).join();
    const found = [`method=${shown.method}`, `gradient=${encodeURIComponent(shown.gradient)}`, `camera=${written(view.place)}`];
    if (lights.turned) found.push(`light=${written(lights.turned.vector.toArray())}`);
    if (settings().isBare) found.push('ui=off');
    history.replaceState(null, '', `#${found.join('&')}`);
}

async function start() {
    element('title').textContent = scene.title;
    const renderer = makeRenderer();
    const lights = new Lights(scene.lights);
    const painter = await Painter.make(renderer, scene, lights, (share) => tell('loading', `Loading ${Math.round(100 * share)} %`));
    const canvas = element('picture'), ball = element('ball'), shown = {};
    let isStale = true, isUntold = false;
    const changed = () => { isStale = true; };
    const view = new ViewCamera(scene.camera, canvas, (camera) => dragLight(canvas, camera, lights, changed));
    dragBall(ball, view, lights, changed);
    ball.hidden = !lights.turned;
    const { chooseMethod, chooseGradient } = makeChoices(painter, shown, changed);

    const apply = () => {
        const { method, gradient, light, camera, isBare } = settings();
        document.documentElement.dataset.ui = isBare ? 'off' : 'on';
        chooseMethod(method ?? shown.method ?? scene.method);
        chooseGradient(gradient ?? shown.gradient ?? 'Own paint');
        if (light) lights.put(light);
        if (camera) view.place = camera;
        fit(renderer, view);
        changed();
    };
    addEventListener('hashchange', apply);
    addEventListener('resize', () => {
        fit(renderer, view);
        changed();
    });
    apply();
    showHint();
    setInterval(() => {
        if (isUntold) tellAddress(shown, lights, view);
        isUntold = false;
    }, addressEvery);

    let frames = 0;
    renderer.setAnimationLoop((time) => {
        const moved = view.update(time);
        if (!moved && !isStale) return;
        isStale = false;
        isUntold = ++frames > 1;
        painter.draw(view.camera);
        drawBall(ball, lights, shown.colors, view.axes(), view.controls.target, scene.camera.radius);
        tell('ready', '');
    });
}

start().catch((error) => {
    console.error(error);
    tell('failed', document.createElement('canvas').getContext('webgl2') ? `This page can’t be shown: ${error.message}`
                                                                         : 'This page needs WebGL 2, which this browser doesn’t offer.');
});
