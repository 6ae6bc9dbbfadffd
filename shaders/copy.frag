#version 300 es
// A finished view, pixel by pixel.
precision mediump float;
uniform sampler2D picture;  // as the screen has it: row 0 at the foot
in vec2 at;
out vec4 colour;
void main() {
  colour = vec4(texture(picture, vec2(at.x, 1.0 - at.y)).rgb, 1.0);
}
