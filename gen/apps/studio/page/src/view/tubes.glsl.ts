import { COLOR, EYE, FLAT, LIGHT, LINEAR } from "./glsl";

/** Branches: tubes of which the server sends both ends, 48 bytes each, as three texels. The corners of a tube are turned
 *  to the eye, so that its outline is right however few sides it has; neighbours share their end's direction and so
 *  their ring. COLUMNS corners a ring; RIBBON: two, the front only, with the normals of a tube. TILED: a picture of the
 *  bark lies along them. The place on it is that in the branch as if it were straight: across on two axes, of which the
 *  first one's angle at the lower end is sent, and along. */
export const TUBES_VERTEX = /* glsl */ `${EYE}${LINEAR}
uniform usampler2D segments;
uniform int count;
out vec3 at;
out vec3 radial;
out vec3 aside;
out float across;
out vec3 color;
#ifdef TILED
uniform float tile_wide, tile_high;
out float along;           // in heights of the picture
flat out float patterned;  // 0: too thin to show the picture .. 1
#ifdef RIBBON
out vec4 sides;    // of the side and of the front, in widths of the picture
#else
out vec2 in_ring;  // in widths of the picture
#endif
#ifndef QUICK
out vec3 first_axis, heading;
#endif
#endif

vec3 way_of(uint packed) { return vec3(ivec3(packed << 24, packed << 16, packed << 8) >> 24) / 127.0; }

void main() {
  int corner = gl_VertexID % (2 * COLUMNS);
  int k = gl_InstanceID * BUNDLE + gl_VertexID / (2 * COLUMNS);
  if (k >= count) { gl_Position = kNowhere; return; }
  ivec2 texel = ivec2(3 * (k % PER_ROW), k / PER_ROW);
  vec4 a = uintBitsToFloat(texelFetch(segments, texel, 0));
  vec4 b = uintBitsToFloat(texelFetch(segments, texel + ivec2(1, 0), 0));
  uvec4 ends = texelFetch(segments, texel + ivec2(2, 0), 0);
  bool upper = (corner & 1) == 1;
  vec4 end = upper ? b : a;

  // Where branches are thinner than pixels some stand for all, so that they neither crawl nor cost.
  float wide = 1.0;
  if (thin > 0.0) {
    float pixels = max(a.w, b.w) / pixel_at(a.xyz);
    if (pixels < thin) {
      float kept = max(pixels / thin, 0.02);
      if (chance(uint(k)) > kept) { gl_Position = kNowhere; return; }
      wide = min(1.0 / kept, thin / max(pixels, 1e-6));
    }
  }
  vec3 way = normalize(way_of(upper ? ends.y : ends.x) + vec3(0, 1e-4, 0));
  vec3 view = toward(end.xyz);
  vec3 side = cross(way, view);
  float length2 = dot(side, side);
  side = length2 > 1e-5 ? side * inversesqrt(length2) : normalize(cross(way, abs(way.x) < 0.7 ? vec3(1, 0, 0) : vec3(0, 0, 1)));
  vec3 front = cross(side, way);
#ifdef RIBBON
  float angle = float(corner >> 1) * 3.14159265;
#else
  float angle = float(corner >> 1) * (6.2831853 / float(COLUMNS));
#endif
  vec3 out_of = side * cos(angle) + front * sin(angle);
  // How far normals lean: as those of a cone, or, where that is a cap, of the ball through both rings.
  float long_ = max(distance(a.xyz, b.xyz), 1e-6), leaning = end.w * clamp((a.w - b.w) / long_, -3.0, 3.0);
  float heart = (a.w * a.w - b.w * b.w - long_ * long_) / (2.0 * long_);
  if (heart > -0.02 * long_ && a.w - b.w > 0.2 * long_) leaning = upper ? heart + long_ : max(heart, 0.0);
  at = end.xyz + out_of * (end.w * wide);
#ifdef RIBBON
  radial = front;
#else
  radial = normalize(out_of * max(end.w, 1e-6) + way * leaning);
#endif
  aside = side;
  across = cos(angle);
  color = linear(unpacked(upper ? ends.w : ends.z).rgb);
#ifdef TILED
  float covered = max(a.w, b.w) / pixel_at(a.xyz);
#ifdef QUICK
  patterned = clamp(0.4 * covered - 1.0, 0.0, 1.0);
#else
  patterned = clamp(covered - 0.8, 0.0, 1.0);
#endif
  along = float((ends.z >> 24) | (ends.w >> 24) << 8) / 65536.0 + (upper ? long_ / tile_high : 0.0);
  vec3 first = way;
  if (patterned > 0.0) {
    vec3 from_way = normalize(way_of(ends.x) + vec3(0, 1e-4, 0)), to_way = normalize(way_of(ends.y) + vec3(0, 1e-4, 0));
    first = normalize(cross(from_way, abs(way_of(ends.x).x) < 0.7 ? vec3(1, 0, 0) : vec3(0, 0, 1)));
    float turn = float((ends.x >> 24) | (ends.y >> 24) << 8) * (6.2831853 / 65536.0);
    first = first * cos(turn) + cross(from_way, first) * sin(turn);
    // By the shortest way to the upper end.
    if (upper) first = normalize(first - (from_way + to_way) * (dot(first, to_way) / max(1.0 + dot(from_way, to_way), 1e-3)));
  }
  vec3 second = cross(way, first);
  vec2 side_ = vec2(dot(side, first), dot(side, second)) * (end.w / tile_wide), front_ = vec2(dot(front, first), dot(front, second)) * (end.w / tile_wide);
#ifdef RIBBON
  sides = vec4(side_, front_);
#else
  in_ring = side_ * cos(angle) + front_ * sin(angle);
#endif
#ifndef QUICK
  first_axis = first;
  heading = way;
#endif
#endif
  gl_Position = projected(at);
}
`;

/** The picture of the bark, laid on from two sides; it varies the colour. */
const BARK = /* glsl */ `
#ifdef TILED
in float along;
flat in float patterned;
#ifdef RIBBON
in vec4 sides;
#else
in vec2 in_ring;
#endif
#ifndef QUICK
in vec3 first_axis, heading;
#endif
uniform sampler2D tile, tile_normals;
uniform float tiled;
uniform vec3 tile_light;
void lay_bark(float across, inout vec3 paint, inout vec3 n) {
  if (tiled * patterned <= 0.0) return;
#ifdef RIBBON
  vec2 p = sides.xy * across + sides.zw * sqrt(max(0.0, 1.0 - across * across));
#else
  vec2 p = in_ring;
#endif
#ifdef QUICK
  vec3 varied = texture(tile, vec2(abs(p.x) < abs(p.y) ? p.x : p.y + 0.37, along)).rgb;
#else
  vec2 at_x = vec2(p.x, along), at_y = vec2(p.y + 0.37, along), share = abs(p) / (abs(p.x) + abs(p.y) + 1e-9) + 0.01;
  share *= share;
  share *= share;
  share *= share;
  share = share.yx / (share.x + share.y);
  vec3 varied = share.x * texture(tile, at_x).rgb + share.y * texture(tile, at_y).rgb;
  vec2 x = share.x * (texture(tile_normals, at_x).rg - 0.5), y = share.y * (texture(tile_normals, at_y).rg - 0.5);
  vec3 first = normalize(first_axis), way = normalize(heading);
  n = normalize(n + 2.0 * patterned * (x.x * first + y.x * cross(way, first) + (x.y + y.y) * way));
#endif
  paint *= mix(vec3(1), tile_light * varied, patterned);
}
#endif
`;

export const TUBES_LOOK = /* glsl */ `${COLOR}${LIGHT}
uniform float gloss;
in vec3 at;
in vec3 radial;
in vec3 aside;
in float across;
in vec3 color;
out vec4 picture;
${BARK}
void main() {
  vec3 paint = color;
#ifdef RIBBON
  vec3 n = normalize(radial * sqrt(max(0.0, 1.0 - across * across)) + aside * across);
#else
  vec3 n = normalize(radial);
#endif
#ifdef TILED
  lay_bark(across, paint, n);
#endif
  picture = vec4(shown(lit(paint, at, n, gloss, 0.0)), 1.0);
}
`;

export const TUBES_FLAT = /* glsl */ `${COLOR}${FLAT}
void main() { flat_picture(); }
`;
