#version 300 es
// The solid view's paper: a soft light from above.
precision mediump float;
uniform vec3 middle, edge;
in vec2 at;
out vec4 colour;
void main() {
  vec2 q = (at - vec2(0.5, 0.38)) * vec2(1.0, 1.15);
  float light = 1.0 - smoothstep(0.0, 0.85, length(q));
  colour = vec4(mix(edge, middle, light), 1.0);
}
