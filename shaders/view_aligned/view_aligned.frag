#version 410 core

#include "common/gbuffer_samples.glsl"
#include "common/gradient.glsl"

// The view-aligned 3D texture (section 4.2). What is compiled in: OCTAVES 1 or 2; TAPS and NEXT_TAPS, a side,
// of the first and the second octave, as core's methods::viewAlignedTexture has them.

uniform sampler3D levels;
uniform vec2 levelRange;           // texel value times x plus y is the difference
uniform samplerBuffer placements;  // three texels an object, see placementOf

out vec4 color;

struct Octave {
    float factor;    // pixels to s; t runs the other way
    vec2 summand;    // of s and t
    float tapStep;   // between taps, in s and t
    float weight;
};

Octave octaveOf(int object, int which) {
    vec4 placement = texelFetch(placements, object * 3 + which);
    vec4 weights = texelFetch(placements, object * 3 + 2);
    return Octave(placement.x, placement.yz, placement.w, which == 0 ? weights.x : weights.y);
}

// Several taps where more than one texel falls on a pixel, around its centre.
vec3 filteredTexel(Octave octave, int side, float light) {
    vec2 centre = gl_FragCoord.xy * vec2(octave.factor, -octave.factor) + octave.summand;
    vec2 first = centre - 0.5 * octave.tapStep * float(side - 1);
    vec3 sum = vec3(0.0);
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i)
            sum += texture(levels, vec3(first + octave.tapStep * vec2(i, j), light)).rgb;
    return octave.weight * (sum / float(side * side) * levelRange.x + levelRange.y);
}

void main() {
    PixelSamples pixel;
    if (!pixelSamples(pixel)) discard;
    int object = pixel.object - 1;
    vec3 difference = filteredTexel(octaveOf(object, 0), TAPS, pixel.light);
#if OCTAVES > 1
    difference += filteredTexel(octaveOf(object, 1), NEXT_TAPS, pixel.light);
#endif
    color = vec4(clamp(gradientColor(pixel.light) + difference, 0.0, 1.0), pixel.coverage);
}
