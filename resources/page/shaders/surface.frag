// What both methods begin with: the light of this place, and G(L).

precision highp float;
precision highp int;
precision highp sampler2D;
precision highp sampler3D;
precision highp usampler2D;

#include "common/light.glsl"

centroid in vec3 worldNormal;
centroid in vec3 worldPosition;

uniform sampler2D gradient;  // W texels in a row
uniform vec2 gradientSpan;   // L times x plus y is the texture coordinate

out vec4 color;

float surfaceLight() {
    // Back sides are lit with the flipped normal.
    return lightValue(worldPosition, normalize(gl_FrontFacing ? worldNormal : -worldNormal));
}

vec3 gradientColor(float light) {
    return texture(gradient, vec2(light * gradientSpan.x + gradientSpan.y, 0.5)).rgb;
}
