#version 300 es
// The picture over a checkerboard where it is transparent.
precision highp float;
uniform sampler2D picture;   // sRGB
uniform vec2 sizeOnScreen;   // CSS pixels
in vec2 at;
out vec4 colour;

vec3 encode(vec3 linear) {
  return mix(12.92 * linear, 1.055 * pow(max(linear, 0.0), vec3(1.0 / 2.4)) - 0.055,
             step(0.0031308, linear));
}

void main() {
  vec4 texel = texture(picture, at);
  vec2 cell = floor(at * sizeOnScreen / 10.0);
  float odd = mod(cell.x + cell.y, 2.0);
  vec3 board = mix(vec3(1.0), vec3(0.91), odd);
  colour = vec4(mix(board, encode(texel.rgb), texel.a), 1.0);
}
