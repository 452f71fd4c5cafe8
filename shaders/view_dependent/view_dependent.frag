#version 410 core

#include "common/gbuffer_samples.glsl"
#include "common/gradient.glsl"

// View-dependent textures (section 4.3): on each face the textures of its views, blended by their weights, as
// core's methods::viewDependentTexture. What is compiled in: TEXTURED 0 for G(L) alone; PERSPECTIVE,
// FOLLOW_CAMERA and PRESERVING 0 or 1; PAGES, 1 unless the views' maps need several pages of texels.

#if TEXTURED
uniform sampler2DMS faces;          // the face of each sample, four bytes, lowest first
uniform samplerBuffer corners;      // three texels a face, object space, about the object's middle
uniform usamplerBuffer faceViews;   // a face: its first texel in `weights`, and their number
uniform usamplerBuffer weights;     // view, and its weights at the face's corners, 0..65535
uniform samplerBuffer views;        // four texels a view, see placeIn and cameraWeight
uniform sampler3D texels;           // the maps of all views side by side; r = L on each page
uniform vec2 texelRange;            // texel value times x plus y is the difference
uniform vec2 levelEnds;             // L of the middles of the first and the last level
uniform mat4 objectToClip;
uniform vec2 pixelSize;             // of a device pixel, clip space
uniform vec2 reach;                 // how far beyond a face: a unit of depth, and at most; see placeOn
uniform vec3 eye;                   // object space, about the object's middle

struct Place {
    vec3 corners[3];
    vec3 weights;  // of the face's corners, none below 0
    vec3 place;    // the same, beyond the face where it continues
    vec3 point;
};

int faceOf(int which) {
    ivec4 bytes = ivec4(texelFetch(faces, ivec2(gl_FragCoord.xy), which) * 255.0 + 0.5);
    return bytes.x | bytes.y << 8 | bytes.z << 16 | bytes.w << 24;
}

float cross2(vec2 a, vec2 b) {
    return a.x * b.y - a.y * b.x;
}

vec3 pointOf(Place place, vec3 weights) {
    return place.corners[0] * weights.x + place.corners[1] * weights.y + place.corners[2] * weights.z;
}

// Where the pixel's middle meets a face, or passes it by: another sample met it. Then the face's plane stands
// for what lies beside it, but not far: at a silhouette it would lead away.
Place placeOn(int face) {
    Place place;
    vec2 pixel = gl_FragCoord.xy * pixelSize - 1.0;
    vec2 offsets[3];
    float depth = 0.0;
    for (int i = 0; i < 3; ++i) {
        place.corners[i] = texelFetch(corners, face * 3 + i).xyz;
        vec4 clip = objectToClip * vec4(place.corners[i], 1.0);
        offsets[i] = clip.xy - pixel * clip.w;
        depth = max(depth, clip.w);
    }
    vec3 areas = vec3(cross2(offsets[1], offsets[2]), cross2(offsets[2], offsets[0]),
                      cross2(offsets[0], offsets[1]));
    float area = areas.x + areas.y + areas.z;
    vec3 plane = area == 0.0 ? vec3(1.0 / 3.0) : areas / area;
    vec3 inside = max(plane, 0.0);
    place.weights = inside / (inside.x + inside.y + inside.z);
    place.point = pointOf(place, place.weights);
    vec3 beyond = pointOf(place, plane) - place.point;
    float limit = min(reach.x * depth, reach.y);
    float share = min(limit * inversesqrt(max(dot(beyond, beyond), 1e-30)), 1.0);
    place.point += share * beyond;
    place.place = mix(place.weights, plane, share);
    return place;
}

vec2 projected(int view, vec3 point) {
    vec4 position = vec4(point, 1.0);
    vec2 place = vec2(dot(texelFetch(views, view * 4), position), dot(texelFetch(views, view * 4 + 1), position));
#if PERSPECTIVE
    place /= dot(texelFetch(views, view * 4 + 2), position);
#endif
    return place;
}

// s and t in a view's map: affine on a face, whatever the projection.
vec2 placeIn(int view, Place place) {
#if PERSPECTIVE
    return projected(view, place.corners[0]) * place.place.x + projected(view, place.corners[1]) * place.place.y +
           projected(view, place.corners[2]) * place.place.z;
#else
    return projected(view, place.point);
#endif
}

#if FOLLOW_CAMERA
// The sharpness is core's.
float cameraWeight(vec3 direction, vec3 point) {
    return exp(6.0 * (dot(normalize(eye - point), direction) - 1.0));
}
#endif

vec3 viewDependentTexture(int face, float light) {
    Place place = placeOn(face);
    float r = clamp(light, levelEnds.x, levelEnds.y) / float(PAGES);
    vec3 sum = vec3(0.0);
    float total = 0.0;
    float squares = 0.0;
    uvec2 range = texelFetch(faceViews, face).xy;
    int end = int(range.x + range.y);
    for (int i = int(range.x); i < end; ++i) {
        uvec4 entry = texelFetch(weights, i);
        int view = int(entry.x);
        float weight = dot(vec3(entry.yzw), place.weights);
        vec3 texel = vec3(placeIn(view, place), r);
#if FOLLOW_CAMERA || PAGES > 1
        vec4 more = texelFetch(views, view * 4 + 3);
        texel.z += more.w;
#endif
#if FOLLOW_CAMERA
        weight *= cameraWeight(more.xyz, place.point);
#endif
        sum += weight * textureLod(texels, texel, 0.0).rgb;
        total += weight;
#if PRESERVING
        squares += weight * weight;
#endif
    }
    if (total <= 0.0) return vec3(0.0);
#if PRESERVING
    float norm = sqrt(squares);
#else
    float norm = total;
#endif
    return (sum * texelRange.x + total * texelRange.y) / norm;
}
#endif

out vec4 color;

void main() {
    PixelSamples pixel;
    if (!pixelSamples(pixel)) discard;
    vec3 shown = gradientColor(pixel.light);
#if TEXTURED
    shown += viewDependentTexture(faceOf(pixel.which), pixel.light);
#endif
    color = vec4(clamp(shown, 0.0, 1.0), pixel.coverage);
}
