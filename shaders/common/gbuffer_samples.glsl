// What the samples of this pixel met, of a range of objects: those that one pass over the picture shades.

uniform sampler2DMS surfaces;
uniform vec2 objectRange;  // first and last id of this pass, 1..65535; earlier passes had those below

struct PixelSamples {
    float light;     // mean L over the samples of this pass
    int object;      // the largest id among them
    int which;       // a sample with that id
    float coverage;  // their share among all samples but those of later passes
};

// False when no sample of the pixel belongs to this pass.
bool pixelSamples(out PixelSamples pixel) {
    float light = 0.0;
    float count = 0.0;
    float earlier = 0.0;
    float largest = 0.0;
    pixel.which = 0;
    float middle = 0.5 * (objectRange.x + objectRange.y);
    float reach = middle - objectRange.x + 0.5;
    for (int i = 0; i < SAMPLES; ++i) {
        vec4 surface = texelFetch(surfaces, ivec2(gl_FragCoord.xy), i);
        float object = dot(surface.zw, vec2(255.0, 255.0 * 256.0));  // a whole number but for rounding
        bool isMine = abs(object - middle) < reach;
        float mine = isMine ? 1.0 : 0.0;
        light += mine * dot(surface.xy, vec2(255.0 * 256.0, 255.0));
        count += mine;
        earlier += object < objectRange.x - 0.5 ? 1.0 : 0.0;
        pixel.which = mine * object > largest ? i : pixel.which;
        largest = max(largest, mine * object);
    }
    if (count == 0.0) return false;
    pixel.object = int(largest + 0.5);
    pixel.light = light / (count * 65535.0);
    // Passes are laid over each other in order; with these shares each ends with the weight of its samples.
    pixel.coverage = count / (count + earlier);
    return true;
}
