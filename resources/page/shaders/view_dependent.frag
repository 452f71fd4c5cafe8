#include "surface.frag"

// View-dependent textures (section 4.3), as shaders/view_dependent/ has them: on each face the textures of its
// views, blended by their weights. What is compiled in: TEXTURED 0 for G(L) alone, PERSPECTIVE, FOLLOW_CAMERA,
// PRESERVING 0 or 1, PAGES.

#if TEXTURED
centroid in vec3 point;
centroid in vec3 corners;
flat in int face;

uniform usampler2D faceViews;  // a face: its first texel in `weights`, and their number
uniform usampler2D weights;    // view, and its weights at the face's corners; ratios matter
uniform sampler2D views;       // a row a view: factors of (point, 1) for s, t and their divisor; direction and page
uniform sampler3D texels;      // the maps of all views side by side; r = L on each page
uniform vec2 texelRange;       // texel value times x plus y is the difference
uniform vec2 levelEnds;        // L of the middles of the first and the last level
uniform vec3 eye;              // object space, less the middle

// Tables are as wide as that.
const int tableWidth = 2048;

uvec4 entryOf(usampler2D table, int index) {
    return texelFetch(table, ivec2(index % tableWidth, index / tableWidth), 0);
}

vec3 viewDependentTexture(float light) {
    vec4 place = vec4(point, 1.0);
    float r = clamp(light, levelEnds.x, levelEnds.y) / float(PAGES);
    vec3 sum = vec3(0.0);
    float total = 0.0;
    float squares = 0.0;
    uvec2 range = entryOf(faceViews, face).xy;
    int end = int(range.x + range.y);
    for (int i = int(range.x); i < end; ++i) {
        uvec4 entry = entryOf(weights, i);
        int view = int(entry.x);
        float weight = dot(vec3(entry.yzw), corners);
        vec3 texel = vec3(dot(texelFetch(views, ivec2(0, view), 0), place), dot(texelFetch(views, ivec2(1, view), 0), place), r);
#if PERSPECTIVE
        texel.xy /= dot(texelFetch(views, ivec2(2, view), 0), place);
#endif
        vec4 more = texelFetch(views, ivec2(3, view), 0);
        texel.z += more.w;
#if FOLLOW_CAMERA
        weight *= exp(6.0 * (dot(normalize(eye - point), more.xyz) - 1.0));  // the sharpness is core's
#endif
        sum += weight * textureLod(texels, texel, 0.0).rgb;
        total += weight;
        squares += weight * weight;
    }
    if (total <= 0.0) return vec3(0.0);
    return (sum * texelRange.x + total * texelRange.y) / (PRESERVING == 1 ? sqrt(squares) : total);
}
#endif

void main() {
    float light = surfaceLight();
    vec3 shown = gradientColor(light);
#if TEXTURED
    shown += viewDependentTexture(light);
#endif
    color = vec4(clamp(shown, 0.0, 1.0), 1.0);
}
