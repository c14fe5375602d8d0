SHADED in vec4 front_color;
SHADED in vec3 back_color;
in float above_cut;

layout(location = 0) out vec4 pixel;

void main() {
    if (above_cut < 0.0) discard;
    pixel = vec4(gl_FrontFacing ? front_color.rgb : back_color, front_color.a);
}
