import { COLOR, EYE, FLAT, LIGHT, LINEAR } from "./glsl";

/** Branches: tubes of which the server sends both ends, 48 bytes each, as three texels. The corners of a tube are turned
 *  to the eye, so that its outline is right however few sides it has; neighbours share their end's direction and so
 *  their ring. COLUMNS corners a ring; RIBBON: two, the front only, with the normals of a tube. */
export const TUBES_VERTEX = /* glsl */ `${EYE}${LINEAR}
uniform usampler2D segments;
uniform int count;
out vec3 at;
out vec3 radial;
out vec3 aside;
out float across;
out vec3 color;

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
  gl_Position = projected(at);
}
`;

export const TUBES_LOOK = /* glsl */ `${COLOR}${LIGHT}
uniform float gloss;
in vec3 at;
in vec3 radial;
in vec3 aside;
in float across;
in vec3 color;
out vec4 picture;
void main() {
#ifdef RIBBON
  vec3 n = normalize(radial * sqrt(max(0.0, 1.0 - across * across)) + aside * across);
#else
  vec3 n = normalize(radial);
#endif
  picture = vec4(shown(lit(color, at, n, gloss, 0.0)), 1.0);
}
`;

export const TUBES_FLAT = /* glsl */ `${COLOR}${FLAT}
void main() { flat_picture(); }
`;
