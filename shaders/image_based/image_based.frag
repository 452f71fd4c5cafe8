#version 410 core

#include "common/gbuffer_samples.glsl"
#include "common/gradient.glsl"

// The image-based texture (section 4.1): made for one view, and carried along by its object until the next is
// there. The gradient and the light are this frame's. LAYERS is 2 while a texture fades in over an earlier one.

uniform sampler2D texels[LAYERS];
uniform vec2 texelRange[LAYERS];  // texel value times x plus y is the difference times the layer's weight
uniform vec4 texelPlace[LAYERS];  // position on the screen to s and t: factors, summands

out vec4 color;

void main() {
    PixelSamples pixel;
    if (!pixelSamples(pixel)) discard;
    vec3 difference = vec3(0.0);
    for (int i = 0; i < LAYERS; ++i) {
        vec2 place = gl_FragCoord.xy * texelPlace[i].xy + texelPlace[i].zw;
        difference += texture(texels[i], place).rgb * texelRange[i].x + texelRange[i].y;
    }
    color = vec4(clamp(gradientColor(pixel.light) + difference, 0.0, 1.0), pixel.coverage);
}
