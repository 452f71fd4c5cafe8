// A vertex of a triangle list without indices: its number tells its face and which corner of it it is.

in vec3 position;
in vec3 normal;

uniform mat4 projectionMatrix;
uniform mat4 modelViewMatrix;
uniform mat4 modelMatrix;
uniform mat3 normalToWorld;
uniform vec3 middle;  // of the object, object space

// At a silhouette a pixel's centre may lie outside the triangle: a centroid keeps all of these inside it.
centroid out vec3 worldNormal;
centroid out vec3 worldPosition;
centroid out vec3 point;    // object space, less the middle
centroid out vec3 corners;  // the weights of the face's corners
flat out int face;

void main() {
    worldNormal = normalToWorld * normal;
    worldPosition = (modelMatrix * vec4(position, 1.0)).xyz;
    point = position - middle;
    face = gl_VertexID / 3;
    int corner = gl_VertexID - 3 * face;
    corners = vec3(corner == 0, corner == 1, corner == 2);
    gl_Position = projectionMatrix * (modelViewMatrix * vec4(position, 1.0));
}
