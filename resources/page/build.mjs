// Makes the relightable page, one HTML file that asks nothing of the network:
// node build.mjs NODE_MODULES SHADERS OUTPUT
import fs from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const [modules, shaders, output] = process.argv.slice(2).map((argument) => path.resolve(argument));
const here = path.dirname(fileURLToPath(import.meta.url));
const esbuild = createRequire(path.join(modules, 'any.js'))('esbuild');

// As the studio's programs: an #include "..." line becomes that file, here or among the studio's shaders.
function withIncludes(file) {
    return fs.readFileSync(file, 'utf8').replace(/^#include "(.*)"$/gm, (line, name) => {
        const places = [path.dirname(file), shaders].map((folder) => path.join(folder, name));
        return withIncludes(places.find((place) => fs.existsSync(place)) ?? line);
    });
}

const glsl = {
    name: 'glsl',
    setup(build) {
        build.onLoad({ filter: /\.(vert|frag)$/ }, ({ path: file }) => ({ contents: withIncludes(file), loader: 'text' }));
    },
};

async function bundled(entry) {
    const result = await esbuild.build({
        entryPoints: [path.join(here, entry)], bundle: true, minify: true, write: false, format: 'iife',
        target: 'es2021', nodePaths: [modules], plugins: [glsl], legalComments: 'none', charset: 'utf8',
    });
    return result.outputFiles[0].text;
}

const [script, style] = await Promise.all([bundled('main.js'), bundled('page.css')]);
const licence = fs.readFileSync(path.join(modules, 'three', 'LICENSE'), 'utf8').replace(/-->/g, '');
const page = fs.readFileSync(path.join(here, 'page.html'), 'utf8')
    // In a script element the text "</script" would end it.
    .replace('/* script */', () => script.replace(/<\/script/gi, '<\\/script'))
    .replace('/* style */', () => style.trim())
    .replace('three.js licence', () => `three.js:\n${licence.trim()}`);
fs.mkdirSync(path.dirname(output), { recursive: true });
fs.writeFileSync(`${output}.new`, page);
fs.renameSync(`${output}.new`, output);
