#version 300 es
// A faint disc with rings, and a shadow that is sharp and dark where a part touches the floor, wide
// and pale where it hovers.
precision highp float;
uniform sampler2D heights;  // r = 1 − height of the lowest surface, 0 where there is none
in vec2 at;
out vec4 result;

// Eight places on each of four rings round p; each ring begins half a step further than the one within it. Directions
// are turned step by step: a processor that draws has no table of sines.
const vec2 kFirst[4] = vec2[4](vec2(1.0, 0.0), vec2(0.92387953, 0.38268343), vec2(0.70710678, 0.70710678),
                               vec2(0.38268343, 0.92387953));
const float kRadius[4] = float[4](0.012, 0.042, 0.102, 0.192);
const float kWeight[4] = float[4](0.05370610, 0.03159182, 0.02237754, 0.01732455);  // of one place; all add up to 1
const mat2 kStep = mat2(0.70710678, 0.70710678, -0.70710678, 0.70710678);

float shade(vec2 p) {
  vec2 middle = 0.5 + 0.5 * p;
  float sum = 0.0;
  for (int ring = 0; ring < 4; ++ring) {
    vec2 way = 0.5 * kRadius[ring] * kFirst[ring];
    float ofRing = 0.0;
    for (int i = 0; i < 8; ++i) {
      float near = texture(heights, middle + way).r;
      ofRing += near * near;
      way = kStep * way;
    }
    sum += kWeight[ring] * ofRing;
  }
  return sum;
}

void main() {
  float r = length(at);
  if (r > 1.0) discard;
  float edge = 1.0 - smoothstep(0.9, 1.0, r);
  float width = fwidth(r) * 1.2;
  float nearest = 0.24 * max(1.0, round(r / 0.24));
  float rings = 1.0 - smoothstep(0.0, width, abs(r - nearest));
  float shadow = shade(at) * 0.5 * edge;
  float paper = 0.055 * edge;
  float line = 0.07 * rings * edge;
  float alpha = 1.0 - (1.0 - shadow) * (1.0 - paper) * (1.0 - line);
  result = vec4(vec3(0.12, 0.13, 0.2), alpha);
}
