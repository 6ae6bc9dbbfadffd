#version 300 es
// The floor's shadow: sharp and dark where a part touches the floor, wide and pale where it hovers.
precision highp float;
uniform sampler2D heights;  // r = 1 − height of the lowest surface, 0 where there is none
in vec2 at;
out vec4 result;

// Eight places on each of four rings; each ring begins half a step further than the one within it. Directions are turned
// step by step: a processor that draws has no table of sines.
const vec2 kFirst[4] = vec2[4](vec2(1.0, 0.0), vec2(0.92387953, 0.38268343), vec2(0.70710678, 0.70710678),
                               vec2(0.38268343, 0.92387953));
const float kRadius[4] = float[4](0.006, 0.021, 0.051, 0.096);
const float kWeight[4] = float[4](0.05370610, 0.03159182, 0.02237754, 0.01732455);  // of one place; all add up to 1
const mat2 kStep = mat2(0.70710678, 0.70710678, -0.70710678, 0.70710678);

void main() {
  float sum = 0.0;
  for (int ring = 0; ring < 4; ++ring) {
    vec2 way = kRadius[ring] * kFirst[ring];
    float ofRing = 0.0;
    for (int i = 0; i < 8; ++i) {
      float near = texture(heights, at + way).r;
      ofRing += near * near;
      way = kStep * way;
    }
    sum += kWeight[ring] * ofRing;
  }
  result = vec4(sum, 0.0, 0.0, 1.0);
}
