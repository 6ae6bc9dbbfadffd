#version 300 es
// Parts seen from above, for the floor's shadow.
uniform mat4 toWorld, toClip;
in vec3 position;
out float height;  // 0 on the floor … 1 at the top
void main() {
  gl_Position = toClip * (toWorld * vec4(position, 1.0));
  height = 0.5 + 0.5 * gl_Position.z;
}
