// What the samples of this pixel met, of a range of objects: those that one pass over the picture shades.

uniform sampler2DMS surfaces;
uniform vec2 objectRange;  // first and last id of this pass, 1..65535; earlier passes had those below

struct PixelSamples {
    float light;     // mean L over the samples of this pass
    float object;    // the largest id among them
    float coverage;  // their share among all samples but those of later passes
};

// False when no sample of the pixel belongs to this pass.
bool pixelSamples(out PixelSamples pixel) {
    float light = 0.0;
    float count = 0.0;
    float earlier = 0.0;
    pixel.object = 0.0;
    for (int i = 0; i < SAMPLES; ++i) {
        vec4 surface = floor(texelFetch(surfaces, ivec2(gl_FragCoord.xy), i) * 255.0 + 0.5);
        float object = surface.z + 256.0 * surface.w;
        float mine = step(objectRange.x, object) * step(object, objectRange.y);
        light += mine * (256.0 * surface.x + surface.y);
        count += mine;
        earlier += step(object, objectRange.x - 0.5);
        pixel.object = max(pixel.object, mine * object);
    }
    if (count == 0.0) return false;
    pixel.light = light / (count * 65535.0);
    // Passes are laid over each other in order; with these shares each ends with the weight of its samples.
    pixel.coverage = count / (count + earlier);
    return true;
}
