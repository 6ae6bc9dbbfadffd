#version 300 es
precision mediump float;
in float height;
out vec4 result;
void main() {
  result = vec4(clamp(1.0 - height, 0.0, 1.0), 0.0, 0.0, 1.0);
}
