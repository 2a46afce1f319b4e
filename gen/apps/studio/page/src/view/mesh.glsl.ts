import { COLOR, EYE, FLAT, LIGHT, LINEAR } from "./glsl";

/** Meshes. INSTANCED: BUNDLE copies of the mesh stand behind each other, and instance after instance takes its place from
 *  a texture of ten numbers each; ORDERED: by way of a list of those that are to be drawn. */
export const MESH_VERTEX = /* glsl */ `${EYE}${LINEAR}
in vec3 position;
in vec3 normal;
#if defined(WITH_UV) || defined(UNROLLED)
in vec2 uv;
out vec2 on_picture;
#endif
#ifdef WITH_COLORS
in vec3 colors;
#endif
uniform vec3 plain;
out vec3 at;
out vec3 up;
out vec3 color;
flat out uint own;
#if defined(TILED) && !defined(UNROLLED)
out vec3 in_place;  // before it is placed
out vec3 in_way;
flat out vec4 turned_by;
#endif
#ifdef INSTANCED
uniform sampler2D places;
uniform int count, corners;
uniform int every;       // one of so many stands for all
uniform float enlarged;  // how many times its size that has
uniform float reach;  // from the middle of the mesh to its farthest corner
#ifdef INSTANCE_COLORS
uniform sampler2D paints;
uniform float tint;
#endif
#ifdef ORDERED
uniform usampler2D order;
#endif
vec3 turned(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }
#endif

void main() {
  color = plain;
#ifdef WITH_COLORS
  color = colors;
#endif
#ifdef INSTANCED
  int k = (gl_InstanceID * BUNDLE + gl_VertexID / corners) * every;
  if (k >= count) { gl_Position = kNowhere; return; }
#ifdef ORDERED
  k = int(texelFetch(order, ivec2(k % ORDER_ROW, k / ORDER_ROW), 0).r);
#endif
  ivec2 texel = ivec2(5 * (k % PER_ROW), k / PER_ROW);
  vec2 a = texelFetch(places, texel, 0).rg, b = texelFetch(places, texel + ivec2(1, 0), 0).rg,
       c = texelFetch(places, texel + ivec2(2, 0), 0).rg, d = texelFetch(places, texel + ivec2(3, 0), 0).rg,
       e = texelFetch(places, texel + ivec2(4, 0), 0).rg;
  vec3 place = vec3(a, b.x), size = vec3(d.y, e);
  vec4 turn = vec4(b.y, c, d.x);
  size *= enlarged;
  // Where they are smaller than pixels some stand for all.
  float pixels = reach * max(size.x, max(size.y, size.z)) / pixel_at(place), least = 3.0 * thin;
  if (pixels < least) {
    float kept = max(pixels / least, 0.1);
    if (chance(uint(k)) > kept * kept) { gl_Position = kNowhere; return; }
    size /= kept;
  }
  at = place + turned(turn, position * size);
  up = turned(turn, normal / size);
  own = uint(k);
#if defined(TILED) && !defined(UNROLLED)
  turned_by = turn;
#endif
#ifdef INSTANCE_COLORS
  vec3 paint = texelFetch(paints, ivec2(k % PER_ROW, k / PER_ROW), 0).rgb;
  color = mix(paint, color * paint * (255.0 / 128.0), tint);
#endif
#else
  at = position;
  up = normal;
  own = 0u;
#if defined(TILED) && !defined(UNROLLED)
  turned_by = vec4(0, 0, 0, 1);
#endif
#endif
#if defined(TILED) && !defined(UNROLLED)
  in_place = position;
  in_way = normal;
#endif
#if defined(WITH_UV) || defined(UNROLLED)
  on_picture = uv;
#endif
  color = linear(color);
  gl_Position = projected(at);
}
`;

/** Holes of leaf pictures, and panes that let some light through as a pattern of dots. */
const HOLES = /* glsl */ `
#ifdef WITH_UV
in vec2 on_picture;
uniform sampler2D leaf;
vec4 on_leaf() {
  vec4 c = texture(leaf, on_picture);
  // Small pictures of leaves are blurred: what is left of them should still cover as much.
  vec2 texels = fwidth(on_picture) * vec2(textureSize(leaf, 0));
  if (c.a * (1.0 + 0.2 * max(0.0, log2(max(max(texels.x, texels.y), 1.0)))) < 0.5) discard;
  return c;
}
#endif
uniform float opacity;
uniform float grain;
void holes() {
  if (opacity >= 1.0) return;
  vec2 p = gl_FragCoord.xy + grain * vec2(47.0, 17.0);
  if (fract(52.9829189 * fract(dot(p, vec2(0.06711056, 0.00583715)))) > opacity) discard;
}
`;

/** Pictures of the material, laid on from the three axes or, UNROLLED, where each corner says; `paint` is what it is
 *  without them, and VARIED by them or replaced. */
const TILES = /* glsl */ `
#ifdef TILED
uniform sampler2D tile;
uniform float tiled;
uniform vec3 tile_light;
void laid(inout vec3 paint, vec3 color) {
#ifdef VARIED
  paint *= tile_light * color;
#else
  paint = tile_light * color;
#endif
}
#endif
#ifdef UNROLLED
in vec2 on_picture;
void lay_tiles(inout vec3 paint, inout vec3 n) {
  if (tiled > 0.5) laid(paint, texture(tile, on_picture).rgb);
}
#elif defined(TILED)
in vec3 in_place;
in vec3 in_way;
flat in vec4 turned_by;
uniform sampler2D tile_normals;
uniform float tile_wide, tile_high;
void lay_tiles(inout vec3 paint, inout vec3 n) {
  if (tiled < 0.5) return;
  vec3 p = in_place / vec3(tile_wide, tile_high, tile_wide), way = normalize(in_way), share = pow(abs(way), vec3(6));
  share /= share.x + share.y + share.z;
  laid(paint, share.x * texture(tile, p.zy).rgb + share.y * texture(tile, p.xz).rgb + share.z * texture(tile, p.xy).rgb);
#ifndef QUICK
  vec2 x = texture(tile_normals, p.zy).rg - 0.5, y = texture(tile_normals, p.xz).rg - 0.5, z = texture(tile_normals, p.xy).rg - 0.5;
  vec3 bent = normalize(way + 2.0 * (share.x * vec3(0, x.yx) + share.y * vec3(y.x, 0, y.y) + share.z * vec3(z, 0)));
  vec3 v = bent - way;
  n = normalize(n + v + 2.0 * cross(turned_by.xyz, cross(turned_by.xyz, v) + turned_by.w * v));
#endif
}
#endif
`;

export const MESH_LOOK = /* glsl */ `${COLOR}${LIGHT}
in vec3 at;
in vec3 up;
in vec3 color;
flat in uint own;
uniform float gloss, through;
uniform float rough;  // of the ground: how much its colour varies
uniform sampler2D painted;
uniform mat4 to_painted;  // from the world to shares of its sides
uniform float paint_shown;  // 0 or how much of it is seen
out vec4 picture;
${HOLES}
${TILES}
float hash(vec2 p) { return fract(sin(dot(p, vec2(127.1, 311.7))) * 43758.5453); }
float noise(vec2 p) {
  vec2 i = floor(p), f = fract(p);
  f *= f * (3.0 - 2.0 * f);
  return mix(mix(hash(i), hash(i + vec2(1, 0)), f.x), mix(hash(i + vec2(0, 1)), hash(i + vec2(1, 1)), f.x), f.y);
}
#ifdef MOSSY
uniform float moss, moss_scale;
float noise(vec3 p) {
  float level = floor(p.y), f = p.y - level;
  return mix(noise(p.xz + 17.3 * level), noise(p.xz + 17.3 * (level + 1.0)), f * f * (3.0 - 2.0 * f));
}
/** As Stone_Mossy of povinc: where stone faces upward and noise has it so. */
void grow_moss(inout vec3 paint, vec3 n) {
  vec3 p = in_place / moss_scale;
  float slope = 0.5 + asin(clamp(n.y, -1.0, 1.0)) / 3.14159265;
  float spots = noise(p / 2.4 + 0.5 * noise(p / 1.2)), fine = noise(p / 0.3);
  float cover = (2.0 * clamp((slope - 0.45) / 0.55, 0.0, 1.0) + 1.1 * clamp((spots - 0.2) / 0.6, 0.0, 1.0) + 0.7 * (0.15 + 0.3 * fine)) / 3.8;
  float from = 0.72 - 0.40 * moss;
  vec3 green = mix(vec3(0.04, 0.065, 0.007), vec3(0.17, 0.21, 0.02), 0.5 * fine + 0.5 * noise(p / 1.3));
  paint = mix(paint, green, smoothstep(from, from + 0.05, cover));
}
#endif
void main() {
  holes();
  vec3 paint = color;
#ifdef WITH_UV
  paint = on_leaf().rgb;
#endif
  vec3 n = normalize(up);
#ifdef TILED
  lay_tiles(paint, n);
#endif
#ifdef MOSSY
  grow_moss(paint, normalize(up));
#endif
  if (!gl_FrontFacing) n = -n;
#ifndef QUICK
  if (rough > 0.0) {
    float far = distance(eye.xyz, at);
    float grains = 0.5 * noise(at.xz * 3.1) + 0.3 * noise(at.xz * 11.0) / (1.0 + 0.1 * far) + 0.2 * noise(at.xz * 47.0) / (1.0 + far);
    paint *= 1.0 + rough * (grains - 0.45);
  }
#endif
  picture = vec4(shown(lit(paint, at, n, gloss, through)), 1.0);
  if (paint_shown > 0.0) {
    float grey = texture(painted, clamp((to_painted * vec4(at, 1)).xy, 0.001, 0.999)).r;
    picture.rgb = mix(picture.rgb, vec3(grey), paint_shown);
  }
}
`;

export const MESH_FLAT = /* glsl */ `${COLOR}${FLAT}
${HOLES}
void main() {
  holes();
#ifdef WITH_UV
  on_leaf();
#endif
  flat_picture();
}
`;
