#version 300 es
// Sky and ground light, one key light over the viewer's left shoulder, a soft highlight. Linear light
// inside, sRGB out.
precision highp float;
uniform sampler2D picture;  // sRGB
uniform vec3 colour;        // sRGB
uniform float textured, glow;
in vec3 eyeNormal, eyePosition;
in vec2 at;
out vec4 result;

vec3 decode(vec3 srgb) {
  return mix(srgb / 12.92, pow((srgb + 0.055) / 1.055, vec3(2.4)), step(0.04045, srgb));
}
vec3 encode(vec3 linear) {
  return mix(12.92 * linear, 1.055 * pow(max(linear, 0.0), vec3(1.0 / 2.4)) - 0.055,
             step(0.0031308, linear));
}

void main() {
  vec3 n = normalize(eyeNormal);
  vec3 v = normalize(-eyePosition);
  vec3 key = normalize(vec3(-0.45, 0.65, 0.75));
  vec3 plain = decode(colour);
  vec4 texel = texture(picture, at);
  vec3 albedo = textured > 0.5 ? mix(plain, texel.rgb, texel.a) : plain;

  float up = 0.5 + 0.5 * n.y;
  vec3 ambient = mix(vec3(0.30, 0.28, 0.27), vec3(0.52, 0.54, 0.58), up);
  float wrapped = max(0.0, (dot(n, key) + 0.25) / 1.25);
  vec3 diffuse = vec3(0.62, 0.60, 0.57) * wrapped;
  float shine = pow(max(0.0, dot(n, normalize(key + v))), 42.0) * 0.16;
  float rim = pow(1.0 - max(0.0, dot(n, v)), 3.0);
  vec3 light = albedo * (ambient + diffuse) + vec3(shine) + vec3(0.05) * rim;
  light = mix(light, vec3(1.0, 0.62, 0.16), glow * rim * 0.55);
  result = vec4(encode(clamp(light, 0.0, 1.0)), 1.0);
}
