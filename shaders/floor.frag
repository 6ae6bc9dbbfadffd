#version 300 es
// A faint disc with rings, and the shadow of the parts.
precision highp float;
uniform sampler2D shadow;  // r, over the square about the disc
in vec2 at;
out vec4 result;

void main() {
  float r = length(at);
  if (r > 1.0) discard;
  float edge = 1.0 - smoothstep(0.9, 1.0, r);
  float width = fwidth(r) * 1.2;
  float nearest = 0.24 * max(1.0, round(r / 0.24));
  float rings = 1.0 - smoothstep(0.0, width, abs(r - nearest));
  float dark = texture(shadow, 0.5 + 0.5 * at).r * 0.5 * edge;
  float paper = 0.055 * edge;
  float line = 0.07 * rings * edge;
  float alpha = 1.0 - (1.0 - dark) * (1.0 - paper) * (1.0 - line);
  result = vec4(vec3(0.12, 0.13, 0.2), alpha);
}
