#version 410 core

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

uniform mat4 objectToClip;
uniform mat3 normalToWorld;
#if POINT_LIGHTS > 0
uniform mat4 objectToWorld;
#endif

// At a silhouette the pixel's centre may lie outside the triangle: a centroid keeps the normal inside it.
centroid out vec3 worldNormal;
centroid out vec3 worldPosition;  // the origin where no light asks for it

void main() {
    worldNormal = normalToWorld * normal;
#if POINT_LIGHTS > 0
    worldPosition = (objectToWorld * vec4(position, 1.0)).xyz;
#else
    worldPosition = vec3(0.0);
#endif
    gl_Position = objectToClip * vec4(position, 1.0);
}
