// A dot as a square of constant size on the screen; the fragments cut out the circle.

uniform mat4 eye_from_item;
uniform mat4 clip_from_eye;
uniform vec2 half_view_px;
uniform float radius_px;
uniform vec2 toward_viewer; // as in line.vert

in vec3 center;
in uvec4 color;

flat out vec4 dot_color;
out vec2 from_center_px;

void main() {
    int corner = gl_VertexID & 3;
    // Half a pixel of room for the soft edge.
    from_center_px = (vec2(corner & 1, corner >> 1) * 2.0 - 1.0) * (radius_px + 0.5);
    dot_color = vec4(color) / 255.0;

    vec3 here = (eye_from_item * vec4(center, 1.0)).xyz;
    vec4 clip = clip_from_eye * vec4(here, 1.0);
    vec3 nearer = here * (1.0 - toward_viewer.x) + vec3(0.0, 0.0, toward_viewer.y);
    vec4 clip_nearer = clip_from_eye * vec4(nearer, 1.0);
    float z = max(clip_nearer.z / clip_nearer.w, -0.99999);
    gl_Position = clip.w > 0.0
        ? vec4(clip.xy + from_center_px / half_view_px * clip.w, z * clip.w, clip.w)
        : vec4(2.0, 2.0, 2.0, 1.0);
}
