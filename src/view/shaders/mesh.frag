SHADED in vec4 front_color;
SHADED in vec3 back_color;

layout(location = 0) out vec4 pixel;

void main() {
    pixel = vec4(gl_FrontFacing ? front_color.rgb : back_color, front_color.a);
}
