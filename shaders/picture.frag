#version 300 es
// The picture over a checkerboard where it is transparent.
precision highp float;
uniform sampler2D picture;   // sRGB
uniform vec2 sizeOnScreen;   // CSS pixels
in vec2 at;
out vec4 colour;

void main() {
  vec4 texel = texture(picture, at);
  vec2 cell = floor(at * sizeOnScreen / 10.0);
  float odd = mod(cell.x + cell.y, 2.0);
  vec3 board = mix(vec3(1.0), vec3(0.91), odd);
  colour = vec4(mix(board, texel.rgb, texel.a), 1.0);
}
