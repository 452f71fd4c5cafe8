// Opens a page in a headless browser and takes pictures of it:
// node page_shots.js MODULE_FOLDER BROWSER PAGE OUT_FOLDER SHOTS
// SHOTS is JSON, a list of {name, hash, then, width, height, mobile, drags: [{from, to, shift, on}]}; `then` is the
// address's next hash, `from` and `to` are pixels, from the top left of the element `on` if it names one. Prints as
// JSON what the browser's console said, which requests the page made besides its own file, and the hash at the end
// of each shot.
const os = require('os');
const fs = require('fs');
const path = require('path');
const puppeteer = require(path.resolve(process.argv[2], 'puppeteer-core'));

const [browserFile, page, folder, shots] = process.argv.slice(3);
const address = `file://${path.resolve(page)}`;
const profile = fs.mkdtempSync(path.join(os.tmpdir(), 'page-'));

const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

/// Waits until nothing moves any more: a turn runs out slowly, and the address tells what is shown.
async function settled(tab) {
    for (let before = '', still = 0; still < 4; await pause(300)) {
        still = tab.url() === before ? still + 1 : 0;
        before = tab.url();
    }
}

async function drag(tab, { from, to, shift, on }) {
    const corner = on ? await tab.$eval(on, (one) => ({ x: one.getBoundingClientRect().x, y: one.getBoundingClientRect().y })) : { x: 0, y: 0 };
    if (shift) await tab.keyboard.down('Shift');
    await tab.mouse.move(corner.x + from[0], corner.y + from[1]);
    await tab.mouse.down();
    await tab.mouse.move(corner.x + to[0], corner.y + to[1], { steps: 6 });
    await tab.mouse.up();
    if (shift) await tab.keyboard.up('Shift');
}

(async () => {
    const browser = await puppeteer.launch({
        executablePath: browserFile, userDataDir: profile, protocolTimeout: 240000,
        args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--no-first-run', '--disable-sync',
               '--disable-background-networking', '--disable-component-update', '--force-color-profile=srgb'],
    });
    const console = [], requests = [], hashes = {};
    try {
        for (const shot of JSON.parse(shots)) {
            const tab = await browser.newPage();
            tab.on('console', (message) => console.push(`${message.type()}: ${message.text()}`));
            tab.on('pageerror', (error) => console.push(`error: ${error.message}`));
            tab.on('request', (request) => request.url().split('#')[0] !== address && !request.url().startsWith('data:') && requests.push(request.url()));
            await tab.setViewport({ width: shot.width, height: shot.height, deviceScaleFactor: shot.mobile ? 2 : 1, isMobile: !!shot.mobile, hasTouch: !!shot.mobile });
            await tab.goto(`${address}#${shot.hash ?? ''}`);
            await tab.waitForSelector('html:not([data-state="loading"])', { timeout: 240000 });
            if (shot.then) await tab.evaluate((hash) => { location.hash = hash; }, shot.then);
            for (const one of shot.drags ?? []) await drag(tab, one).then(() => settled(tab));
            await settled(tab);
            await tab.screenshot({ path: path.join(folder, `${shot.name}.png`) });
            hashes[shot.name] = decodeURIComponent(tab.url().split('#')[1] ?? '');
            await tab.close();
        }
    } finally {
        await browser.close();
        fs.rmSync(profile, { recursive: true, force: true });
    }
    process.stdout.write(JSON.stringify({ console, requests, hashes }));
})();
