#version 300 es
// The unit square, put anywhere in the viewport.
uniform vec4 place;  // left, top, width, height in clip coordinates (height negative: v runs down)
in vec2 corner;
out vec2 at;
void main() {
  at = corner;
  gl_Position = vec4(place.xy + corner * place.zw, 0.0, 1.0);
}
