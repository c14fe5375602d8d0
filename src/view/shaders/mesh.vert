// Facets, lit once per corner: the normal is the same at all three corners of a facet, and so is the
// colour (SHADED is flat) unless colours run together (smooth). The fragments have nothing left to
// compute; that keeps software OpenGL quick.

uniform mat4 eye_from_item;
uniform mat4 clip_from_eye;
uniform vec3 up_in_item; // the scene's z in the item's frame
uniform vec4 cut_in_item; // below this plane nothing is drawn
uniform int see_through; // 0 draws opaque facets, 1 those with alpha below 255

in vec3 position;
in uint packed_normal;
in uvec4 color;

SHADED out vec4 front_color;
SHADED out vec3 back_color;
out float above_cut;

// Over the viewer's left shoulder.
const vec3 KEY = normalize(vec3(-0.45, 0.55, 0.90));
const vec3 HALFWAY = normalize(KEY + vec3(0.0, 0.0, 1.0));

// 8-bit colours are sRGB; light adds up in linear light only.
vec3 to_linear(vec3 srgb) { return pow(srgb, vec3(2.2)); }
vec3 to_srgb(vec3 light) { return pow(clamp(light, 0.0, 1.0), vec3(1.0 / 2.2)); }

float brightness(vec3 normal_in_eye, float up) {
    float key = max(dot(normal_in_eye, KEY), 0.0);
    float fill = max(normal_in_eye.z, 0.0);
    float sky = 0.5 + 0.5 * up;
    // A facet seen squarely (normal 0 0 1, sky a half) must keep its colour: hence the rest.
    float rest = 1.0 - 0.48 * KEY.z - 0.20 - 0.30 * 0.5;
    return 0.48 * key + 0.20 * fill + 0.30 * sky + rest;
}

vec3 lit(vec3 surface, vec3 normal_in_eye, float up) {
    float sheen = pow(max(dot(normal_in_eye, HALFWAY), 0.0), 40.0) * 0.06;
    return surface * brightness(normal_in_eye, up) + sheen;
}

void main() {
    uvec3 parts = uvec3(packed_normal, packed_normal >> 10u, packed_normal >> 20u) & 1023u;
    vec3 normal = vec3(parts) / 511.0 - 1.0;
    vec3 normal_in_eye = mat3(eye_from_item) * normal;
    float up = dot(normal, up_in_item);
    vec3 surface = to_linear(vec3(color.rgb) / 255.0);

    front_color = vec4(to_srgb(lit(surface, normal_in_eye, up)), float(color.a) / 255.0);
    // The inside of an open sheet: darker and warmer.
    vec3 inside = surface * vec3(0.52, 0.44, 0.38);
    back_color = to_srgb(lit(inside, -normal_in_eye, -up));

    above_cut = dot(cut_in_item, vec4(position, 1.0));
    bool wanted = see_through == 0 ? color.a == 255u : (color.a > 0u && color.a < 255u);
    gl_Position = wanted ? clip_from_eye * (eye_from_item * vec4(position, 1.0))
                         : vec4(2.0, 2.0, 2.0, 1.0); // outside: the facet disappears
}
