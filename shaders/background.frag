#version 300 es
// The solid view's paper: a soft light from above.
precision mediump float;
uniform float dark;
in vec2 at;
out vec4 colour;
void main() {
  vec2 q = (at - vec2(0.5, 0.38)) * vec2(1.0, 1.15);
  float light = 1.0 - smoothstep(0.0, 0.85, length(q));
  vec3 paper = mix(vec3(0.925, 0.914, 0.886), vec3(0.988, 0.984, 0.973), light);
  vec3 night = mix(vec3(0.090, 0.098, 0.118), vec3(0.176, 0.192, 0.224), light);
  colour = vec4(mix(paper, night, dark), 1.0);
}
