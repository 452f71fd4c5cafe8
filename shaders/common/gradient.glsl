// G(L), as core's gradient::lookUp has it: 0 is the centre of the first texel, 1 that of the last.

uniform sampler1D gradient;
uniform vec2 gradientSpan;  // L times x plus y is the texture coordinate

vec3 gradientColor(float light) {
    return texture(gradient, light * gradientSpan.x + gradientSpan.y).rgb;
}
