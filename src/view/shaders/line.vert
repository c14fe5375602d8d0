// A segment as a quad of constant width on the screen. Its four vertices all carry both ends;
// the vertex number says which corner this is.

uniform mat4 eye_from_item;
uniform mat4 clip_from_eye;
uniform vec2 half_view_px;
uniform float half_width_px;
uniform float near_z;       // eye z of the near plane; huge in parallel projection
uniform vec2 toward_viewer; // bias as a share of the depth (perspective) and in mm (parallel)

in vec3 end_a;
in vec3 end_b;
in uvec4 color;

flat out vec4 line_color;

void main() {
    vec3 a = (eye_from_item * vec4(end_a, 1.0)).xyz;
    vec3 b = (eye_from_item * vec4(end_b, 1.0)).xyz;
    line_color = vec4(color) / 255.0;

    // Cut off what lies behind the viewer, or the division by w mirrors it into the picture.
    if ((a.z > near_z && b.z > near_z) || color.a == 0u) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }
    if (a.z > near_z) { a = mix(b, a, (near_z - b.z) / (a.z - b.z)); }
    if (b.z > near_z) { b = mix(a, b, (near_z - a.z) / (b.z - a.z)); }

    vec4 clip_a = clip_from_eye * vec4(a, 1.0);
    vec4 clip_b = clip_from_eye * vec4(b, 1.0);
    vec2 px_a = clip_a.xy / clip_a.w * half_view_px;
    vec2 px_b = clip_b.xy / clip_b.w * half_view_px;
    vec2 along = px_b - px_a;
    float length_px = length(along);
    along = length_px > 1e-4 ? along / length_px : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);

    int corner = gl_VertexID & 3;
    bool at_b = (corner & 2) != 0;
    float side = (corner & 1) != 0 ? 1.0 : -1.0;
    vec3 here = at_b ? b : a;
    float w = at_b ? clip_b.w : clip_a.w;
    // Ends reach out by half the width: neighbouring pieces of a polyline close at the bend.
    vec2 px = (at_b ? px_b : px_a)
        + (across * side + along * (at_b ? 1.0 : -1.0)) * half_width_px;

    // A little nearer along the ray, so that a line on a surface is not half buried in it.
    vec3 nearer = here * (1.0 - toward_viewer.x) + vec3(0.0, 0.0, toward_viewer.y);
    vec4 clip_nearer = clip_from_eye * vec4(nearer, 1.0);
    float z = max(clip_nearer.z / clip_nearer.w, -0.99999);
    gl_Position = vec4(px / half_view_px * w, z * w, w);
}
