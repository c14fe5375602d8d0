uniform float radius_px;

flat in vec4 dot_color;
in vec2 from_center_px;

layout(location = 0) out vec4 pixel;

void main() {
    float inside = clamp(radius_px + 0.5 - length(from_center_px), 0.0, 1.0);
    if (inside <= 0.0) { discard; }
    pixel = vec4(dot_color.rgb, dot_color.a * inside);
}
