#version 410 core

#include "common/gbuffer_samples.glsl"
#include "common/gradient.glsl"

// The image-based texture (section 4.1): made for one view, and carried along by its object until the next is
// there. The gradient and the light are this frame's.

uniform sampler2D texels;
uniform vec2 texelRange;  // texel value times x plus y is the difference
uniform vec4 texelPlace;  // position on the screen to s and t: factors, summands

out vec4 color;

void main() {
    PixelSamples pixel;
    if (!pixelSamples(pixel)) discard;
    vec2 place = gl_FragCoord.xy * texelPlace.xy + texelPlace.zw;
    vec3 difference = texture(texels, place).rgb * texelRange.x + texelRange.y;
    color = vec4(clamp(gradientColor(pixel.light) + difference, 0.0, 1.0), pixel.coverage);
}
