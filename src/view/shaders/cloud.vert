// A measured point as a square of constant size on the screen; OpenGL makes the square.

uniform mat4 eye_from_item;
uniform mat4 clip_from_eye;
uniform float side_px;
uniform vec2 toward_viewer; // as in line.vert, but both at once
uniform vec3 fade;          // eye z of the nearest point, 1 / depth of the cloud, how much darker the farthest is

in vec3 place;
in uvec4 color;

flat out vec4 point_color;

void main() {
    gl_PointSize = side_px;

    vec3 here = (eye_from_item * vec4(place, 1.0)).xyz;
    float farther = clamp((fade.x - here.z) * fade.y, 0.0, 1.0);
    point_color = vec4(vec3(color.rgb) / 255.0 * (1.0 - fade.z * farther), 1.0);
    vec4 clip = clip_from_eye * vec4(here, 1.0);
    vec4 nearer = clip_from_eye * vec4(here.xy, here.z * (1.0 - toward_viewer.x) + toward_viewer.y, 1.0);
    float z = max(nearer.z / nearer.w, -0.99999);
    // What is nearer than the lift allows, or no number, is left out.
    gl_Position = clip.w > 0.0 && nearer.w > 0.0 && color.a > 0u
        ? vec4(clip.xy, z * clip.w, clip.w)
        : vec4(2.0, 2.0, 2.0, 1.0);
}
