#version 410 core

#include "common/light.glsl"

centroid in vec3 worldNormal;
centroid in vec3 worldPosition;

uniform vec2 objectId;  // low and high byte, each 0..255; 0 0 is nothing

// Light in 16 bits and the object's id in 16 bits: what common/gbuffer_samples.glsl reads.
layout(location = 0) out vec4 surface;
#if FACES
layout(location = 1) out vec4 face;  // the triangle's number in its mesh, four bytes, lowest first
#endif

void main() {
    // Back sides are lit with the flipped normal.
    vec3 normal = normalize(gl_FrontFacing ? worldNormal : -worldNormal);
    float light = floor(lightValue(worldPosition, normal) * 65535.0 + 0.5);
    float high = floor(light / 256.0);
    surface = vec4(high, light - 256.0 * high, objectId) / 255.0;
#if FACES
    uint number = uint(gl_PrimitiveID);
    face = vec4(number & 255u, number >> 8 & 255u, number >> 16 & 255u, number >> 24) / 255.0;
#endif
}
