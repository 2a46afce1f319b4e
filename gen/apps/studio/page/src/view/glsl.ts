/** What the shaders have in common. Colours are worked with as linear light; POV-Ray's pictures are not tone mapped. */

/** For vertex shaders: the eye, and how much a pixel covers. */
export const EYE = /* glsl */ `
precision highp float;
precision highp int;
precision highp usampler2D;
uniform mat4 viewMatrix, projectionMatrix;
uniform vec4 eye;     // where it is, and 1; or the way towards it, and 0
uniform float pixel;  // metres across a pixel, one metre away or (towards infinity) everywhere
uniform float thin;   // what is thinner than so many pixels is thinned out

vec3 toward(vec3 p) { return normalize(eye.xyz - p * eye.w); }
float pixel_at(vec3 p) { return pixel * mix(1.0, distance(eye.xyz, p), eye.w); }
vec4 projected(vec3 p) { return projectionMatrix * (viewMatrix * vec4(p, 1.0)); }
const vec4 kNowhere = vec4(0.0, 0.0, 2.0, 1.0);

float chance(uint n) {
  n = (n ^ 61u) ^ (n >> 16); n *= 9u; n ^= n >> 4; n *= 0x27d4eb2du; n ^= n >> 15;
  return float(n & 0xffffffu) / 16777216.0;
}
vec4 unpacked(uint c) { return vec4(c & 255u, (c >> 8) & 255u, (c >> 16) & 255u, c >> 24) / 255.0; }
`;

/** Linear light from colours. */
export const LINEAR = /* glsl */ `
vec3 linear(vec3 c) { return c * (c * (c * 0.305306011 + 0.682171111) + 0.012522878); }
`;

/** For fragment shaders: colours from linear light, by square roots, which are much cheaper than powers. */
export const COLOR = /* glsl */ `
precision highp float;
precision highp int;
${LINEAR}
vec3 shown(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  vec3 r = sqrt(c), s = sqrt(r);
  return 0.662002687 * r + 0.684122060 * s - 0.323583601 * sqrt(s) - 0.0225411470 * c;
}
`;

/** For fragment shaders: sun with its shadows, light from all around, haze. QUICK: hard shadows. */
export const LIGHT = /* glsl */ `
precision highp sampler2DShadow;
uniform vec3 sun, sun_light, from_above, from_aside, from_below, from_eye;
uniform vec4 haze;     // colour, metres
uniform vec4 eye;
uniform sampler2DShadow shade;
uniform mat4 to_shade;
uniform float shade_texel;  // metres, 0: no shadows

float sunlight(vec3 p, vec3 n) {
  if (shade_texel <= 0.0) return 1.0;
  vec3 at = (to_shade * vec4(p + (n * 1.5 + sun) * shade_texel, 1.0)).xyz * 0.5 + 0.5;
  if (any(greaterThan(abs(at - 0.5), vec3(0.5)))) return 1.0;
#ifdef QUICK
  return texture(shade, at);
#else
  vec2 d = 0.75 / vec2(textureSize(shade, 0));
  return 0.25 * (texture(shade, at + vec3(d.x, d.y, 0)) + texture(shade, at + vec3(-d.x, d.y, 0)) +
                 texture(shade, at + vec3(d.x, -d.y, 0)) + texture(shade, at + vec3(-d.x, -d.y, 0)));
#endif
}

vec3 lit(vec3 color, vec3 p, vec3 n, float gloss, float through) {
  vec3 to_eye = eye.xyz - p;
  float away = length(to_eye), facing = dot(n, sun);
  float seen = abs(dot(n, to_eye)) / away;
  vec3 light = color * (mix(from_aside, n.y > 0.0 ? from_above : from_below, abs(n.y)) + from_eye * seen);
  if (facing > 0.0 || through > 0.0) {
    float shine = sunlight(p, n);
    light += color * sun_light * (shine * (max(facing, 0.0) + through * max(-facing, 0.0)));
    if (gloss > 0.02 && facing > 0.0)
      light += sun_light * (shine * gloss * 0.25 * pow(max(dot(n, normalize(sun + to_eye / away)), 0.0), 8.0 + 60.0 * gloss));
  }
  return haze.w > 0.0 ? mix(haze.rgb, light, exp(-away / haze.w)) : light;
}
`;

/** What the passes that light nothing put out: a number to pick by, or white where organisms are. */
export const FLAT = /* glsl */ `
uniform vec4 number;
uniform float mask;
uniform float organism;
out vec4 picture;
void flat_picture() { picture = mask > 0.5 ? vec4(vec3(organism), 1.0) : number; }
`;
