// What the exporter put into the page: a JSON of the scene, and its parts as base64 in elements of their own.

export const scene = JSON.parse(document.getElementById('scene').textContent);

function bytesOf(part) {
    const element = document.getElementById(`part-${part}`);
    const text = atob(element.textContent);
    element.remove();  // large, and asked for once
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < bytes.length; ++i) bytes[i] = text.charCodeAt(i);
    return bytes;
}

/// A part that was deflated, as an ArrayBuffer.
export async function inflated(part) {
    const stream = new Blob([bytesOf(part)]).stream().pipeThrough(new DecompressionStream('deflate'));
    return new Response(stream).arrayBuffer();
}

/// A part that is a picture, its values just as they are stored.
export function picture(part) {
    return createImageBitmap(new Blob([bytesOf(part)]), { colorSpaceConversion: 'none', premultiplyAlpha: 'none' });
}
