// L of a surface (section 4), as core's scene::lightValue has it.

// All lights that wrap around, (1 + n.l)/2, in one, since their sum is linear in n: the sum of intensity/2
// times the unit vector towards the light, and the sum of intensity/2.
uniform vec4 wrappedLight;

// The lights that do not, max(n.l, 0): intensity times the unit vector. Their number is compiled in: a loop
// of unknown length costs software renderers more than all the rest.
#if HARD_LIGHTS > 0
uniform vec3 hardLights[HARD_LIGHTS];
#endif

// The lights at a point: where they stand, and what each gives at a right angle and at an angle of 0 besides.
#if POINT_LIGHTS > 0
uniform vec3 pointLights[POINT_LIGHTS];
uniform vec2 pointShine[POINT_LIGHTS];
#endif

float lightValue(vec3 position, vec3 normal) {
    float sum = dot(normal, wrappedLight.xyz) + wrappedLight.w;
#if HARD_LIGHTS > 0
    for (int i = 0; i < HARD_LIGHTS; ++i) sum += max(dot(normal, hardLights[i]), 0.0);
#endif
#if POINT_LIGHTS > 0
    for (int i = 0; i < POINT_LIGHTS; ++i) {
        vec3 way = pointLights[i] - position;
        float cosine = dot(normal, way) * inversesqrt(max(dot(way, way), 1e-30));
        sum += max(pointShine[i].x + pointShine[i].y * cosine, 0.0);
    }
#endif
    return clamp(sum, 0.0, 1.0);
}
