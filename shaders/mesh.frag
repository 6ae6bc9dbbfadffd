#version 300 es
// Sky and ground light, one key light over the viewer's left shoulder, a soft highlight. Linear light
// inside, sRGB out.
precision highp float;
uniform sampler2D picture;  // sRGB
uniform vec3 colour, second;  // linear; the second one below `split`
uniform float split;
uniform int finish;  // 0 plain, 1 clay, 2 glaze, 3 metal
uniform float textured, glow;
#ifdef CUT
uniform float side;  // of the plane that is drawn: -1 behind it, 1 before it and faint, 2 the depths of that alone
in float before;
#endif
in vec3 eyeNormal, eyePosition;
in vec2 at;
in float modelHeight;
out vec4 result;

vec3 encode(vec3 linear) {
  return mix(12.92 * linear, 1.055 * pow(max(linear, 0.0), vec3(1.0 / 2.4)) - 0.055,
             step(0.0031308, linear));
}

// Within 1.4 steps of 255: a processor that draws takes long for powers.
vec3 decode(vec3 srgb) { return srgb * (0.04728 + srgb * (0.54867 + srgb * 0.40405)); }

// What a ball of the material shows towards the normal n of the eye (a matcap, by formula).
vec3 ball(vec3 n, vec3 albedo) {
  float top = dot(n, normalize(vec3(-0.4, 0.75, 0.55)));
  float edge = 1.0 - n.z;
  if (finish == 1) {  // dull, with warm shade and a soft bright rim
    vec3 shade = albedo * albedo * vec3(0.50, 0.42, 0.40);
    return mix(shade, albedo * 1.02, smoothstep(-0.7, 0.9, top)) + vec3(0.10) * edge * edge;
  }
  if (finish == 2) {  // a window reflected in it
    vec3 base = albedo * mix(0.42, 1.0, smoothstep(-0.8, 0.8, top));
    float window = smoothstep(0.86, 0.90, top) + 0.35 * smoothstep(0.80, 0.97, dot(n, normalize(vec3(0.6, -0.1, 0.6))));
    return base + vec3(0.75) * window + vec3(0.28) * pow(edge, 3.0);
  }
  // Sky, horizon and ground, mirrored.
  float height = n.y * 0.9 + 0.12 * n.x;
  float sky = smoothstep(0.02, 0.75, height), ground = smoothstep(-0.06, -0.8, height);
  float mirror = 0.20 + 0.75 * sky + 0.35 * ground + 0.9 * smoothstep(0.90, 0.97, top);
  return mix(albedo, vec3(1.0), 0.18) * mirror + vec3(0.15) * pow(edge, 2.0);
}

void main() {
  vec3 n = normalize(eyeNormal);
  vec3 v = normalize(-eyePosition);
  vec3 key = normalize(vec3(-0.45, 0.65, 0.75));
  float soft = max(fwidth(modelHeight), 1e-5);
  vec3 plain = mix(second, colour, smoothstep(split - soft, split + soft, modelHeight));
  vec4 texel = texture(picture, at);
#ifdef CUT
  float pixel = max(fwidth(before), 1e-7);
  if (side * before < 0.0) discard;
  if (side > 1.0 || !gl_FrontFacing) {  // the inside of what is cut open, flat: a section
    result = vec4(encode(colour * 0.72), 1.0);
    return;
  }
#endif
  vec3 albedo = textured > 0.5 ? mix(plain, decode(texel.rgb), texel.a) : plain;

  float up = 0.5 + 0.5 * n.y;
  vec3 ambient = mix(vec3(0.25, 0.235, 0.225), vec3(0.44, 0.455, 0.49), up);
  float wrapped = max(0.0, (dot(n, key) + 0.25) / 1.25);
  vec3 diffuse = vec3(0.76, 0.735, 0.70) * wrapped;
  float shine = pow(max(0.0, dot(n, normalize(key + v))), 42.0) * 0.16;
  float away = 1.0 - max(0.0, dot(n, v));
  float rim = away * away * away;
  // Darker towards its outline, so that white stands out before paper.
  vec3 light = albedo * (ambient + diffuse) * (1.0 - 0.4 * rim) + vec3(shine) + vec3(0.05) * rim;
  if (finish != 0) light = ball(n, plain);
  light = mix(light, 1.0 - 0.4 * exp(1.5 - 2.5 * light), step(0.6, light));  // white keeps its shading as well
  light = mix(light, vec3(1.0, 0.62, 0.16), glow * rim * 0.55);
  float strength = 1.0;
#ifdef CUT
  if (side < 0.0) light *= mix(0.3, 1.0, smoothstep(0.0, 2.0 * pixel, -before));  // the section's outline
  if (side > 0.0) strength = 0.2 + 0.3 * rim;
#endif
  result = vec4(encode(clamp(light, 0.0, 1.0)), strength);
}
