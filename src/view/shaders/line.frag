flat in vec4 line_color;

layout(location = 0) out vec4 pixel;

void main() {
    pixel = line_color;
}
