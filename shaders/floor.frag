#version 300 es
// A faint disc with rings, and a shadow that is sharp and dark where a part touches the floor, wide
// and pale where it hovers.
precision highp float;
uniform sampler2D heights;  // r = 1 − height of the lowest surface, 0 where there is none
in vec2 at;
out vec4 result;

float shade(vec2 p) {
  float sum = 0.0, weight = 0.0;
  for (int ring = 0; ring < 4; ++ring) {
    float radius = 0.012 + 0.03 * float(ring) * float(ring + 1) * 0.5;
    float w = 1.0 / (1.0 + float(ring) * 0.7);
    for (int i = 0; i < 8; ++i) {
      float a = 0.7853982 * (float(i) + 0.5 * float(ring));
      float near = texture(heights, 0.5 + 0.5 * (p + radius * vec2(cos(a), sin(a)))).r;
      sum += w * near * near;
      weight += w;
    }
  }
  return sum / weight;
}

void main() {
  float r = length(at);
  if (r > 1.0) discard;
  float edge = 1.0 - smoothstep(0.9, 1.0, r);
  float width = fwidth(r) * 1.2;
  float rings = 0.0;
  for (int i = 1; i <= 4; ++i) {
    rings = max(rings, 1.0 - smoothstep(0.0, width, abs(r - 0.24 * float(i))));
  }
  float shadow = shade(at) * 0.5 * edge;
  float paper = 0.055 * edge;
  float line = 0.07 * rings * edge;
  float alpha = 1.0 - (1.0 - shadow) * (1.0 - paper) * (1.0 - line);
  result = vec4(vec3(0.12, 0.13, 0.2), alpha);
}
