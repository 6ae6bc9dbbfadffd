#version 300 es
// The ground and the solids on it that were drawn before, pixel by pixel, at the depths they have.
precision highp float;
uniform highp sampler2D colours, depths;
uniform ivec2 origin;  // of the view on the canvas, pixels from its foot
out vec4 result;
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy) - origin;
  gl_FragDepth = texelFetch(depths, at, 0).r;
  result = texelFetch(colours, at, 0);
}
