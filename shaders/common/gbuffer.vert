#version 410 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

uniform mat4 objectToClip;
uniform mat3 normalToWorld;

// At a silhouette the pixel's centre may lie outside the triangle: a centroid keeps the normal inside it.
centroid out vec3 worldNormal;

void main() {
    worldNormal = normalToWorld * normal;
    gl_Position = objectToClip * vec4(position, 1.0);
}
