flat in vec4 point_color;

layout(location = 0) out vec4 pixel;

void main() {
    pixel = point_color;
}
