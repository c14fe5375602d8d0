uniform vec3 top_color;
uniform vec3 bottom_color;

in float height;

layout(location = 0) out vec4 pixel;

void main() {
    vec3 color = mix(bottom_color, top_color, height);
    // A fixed pattern of less than one step hides the bands of a gradient over few 8-bit steps.
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    pixel = vec4(color + (noise - 0.5) / 255.0, 1.0);
}
