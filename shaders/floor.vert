#version 300 es
// A disc behind the parts, wherever they are.
uniform mat4 toClip;
uniform vec4 disc;  // centre and radius
in vec2 corner;
out vec2 at;        // −1 … 1
void main() {
  at = corner * 2.0 - 1.0;
  gl_Position = toClip * vec4(disc.x + at.x * disc.w, disc.y, disc.z + at.y * disc.w, 1.0);
  gl_Position.z = gl_Position.w;
}
