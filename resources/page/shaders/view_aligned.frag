#include "surface.frag"

// The view-aligned 3D texture (section 4.2), as shaders/view_aligned/ has it.

uniform sampler3D levels;
uniform vec2 levelRange;    // texel value times x plus y is the difference
uniform vec4 octaves[2];    // pixels to s; summands of s and of t; step between taps, in s and t
uniform vec2 octaveWeights;
uniform ivec2 octaveTaps;   // a side: 1, 2 or 4

vec3 filteredTexel(vec4 octave, int side, float light) {
    vec2 centre = gl_FragCoord.xy * vec2(octave.x, -octave.x) + octave.yz;
    vec2 first = centre - 0.5 * octave.w * float(side - 1);
    vec3 sum = vec3(0.0);
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) sum += texture(levels, vec3(first + octave.w * vec2(i, j), light)).rgb;
    return sum / float(side * side) * levelRange.x + levelRange.y;
}

void main() {
    float light = surfaceLight();
    vec3 difference = octaveWeights.x * filteredTexel(octaves[0], octaveTaps.x, light);
    if (octaveWeights.y > 0.0) difference += octaveWeights.y * filteredTexel(octaves[1], octaveTaps.y, light);
    color = vec4(clamp(gradientColor(light) + difference, 0.0, 1.0), 1.0);
}
