#version 300 es
// Parts: from ModelSpace through the world to the screen.
uniform mat4 toWorld, toClip, toEye;
uniform vec4 area;  // of the uv that the texture covers: left, top, width, height
in vec3 position;
in vec3 normal;
in vec2 uv;
out vec3 eyeNormal, eyePosition;
out vec2 at;
out float modelHeight;
#ifdef CUT
uniform vec4 plane;  // of the world: unit normal and offset
out float before;  // the plane, world units
#endif
void main() {
  vec4 world = toWorld * vec4(position, 1.0);
  eyeNormal = mat3(toEye) * (mat3(toWorld) * normal);  // turned or mirrored, evenly scaled
  eyePosition = (toEye * world).xyz;
  modelHeight = position.y;
#ifdef CUT
  before = dot(plane.xyz, world.xyz) - plane.w;
#endif
  at = (uv - area.xy) / area.zw;
  gl_Position = toClip * world;
}
