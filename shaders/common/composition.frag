#version 410 core

// Two pictures as one, as widgets::composed() does it. MODE is 0 for a wipe, 1 for a blend, 2 for a
// difference.

uniform sampler2D first;
uniform sampler2D second;
uniform vec3 amount;  // of the mode: the wipe line's normal and offset; the second's share; the gain

out vec4 color;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 a = texelFetch(first, pixel, 0).rgb;
    vec3 b = texelFetch(second, pixel, 0).rgb;
#if MODE == 0
    color = vec4(dot(gl_FragCoord.xy, amount.xy) > amount.z ? b : a, 1.0);
#elif MODE == 1
    color = vec4(mix(a, b, amount.x), 1.0);
#else
    color = vec4(min(abs(a - b) * amount.x, 1.0), 1.0);
#endif
}
