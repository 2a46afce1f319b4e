/** How corals are shaded: cups or valleys of their skin, light that falls through water, and what shades it. */

const LIGHT = `
uniform vec3 sun;               // toward it, in the world
uniform mat4 shadow_view;       // from the world to the picture that the sun sees
uniform highp sampler2DShadow shadow;
float hash(vec2 p) { return fract(sin(dot(p, vec2(127.1, 311.7))) * 43758.5453); }
float ripple(vec2 p) {
  vec2 i = floor(p);
  float near = 9.0, second = 9.0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      vec2 cell = i + vec2(x, y);
      float d = distance(p, cell + 0.5 + 0.42 * sin(6.2832 * vec2(hash(cell), hash(cell + 17.0))));
      second = min(second, max(near, d));
      near = min(near, d);
    }
  return pow(clamp(1.0 - 2.2 * (second - near), 0.0, 1.0), 3.0);
}
/** What the surface of the water gathers of the sun. */
float caustics(vec3 place, float size) {
  vec2 p = (place.xz - place.y * sun.xz / sun.y) / size;
  p += 0.25 * sin(p.yx * 2.1);
  return 0.78 + 0.75 * ripple(p * 3.1) * ripple(p * 3.1 + 4.7) + 0.30 * ripple(p * 1.7 + 9.2);
}
float lit(vec3 place, float facing) {
  vec3 at = (shadow_view * vec4(place, 1)).xyz;
  at = at * 0.5 + 0.5;
  at.z -= 0.0015 + 0.004 * (1.0 - facing);
  float sum = 0.0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) sum += texture(shadow, at + vec3(vec2(x, y) * 1.3 / 2048.0, 0));
  return sum / 9.0;
}
vec3 under_water(vec3 albedo, vec3 normal, vec3 place, float open, float size) {
  float facing = dot(normal, sun);
  vec3 direct = vec3(2.75, 2.65, 2.35) * max(facing, 0.0) * lit(place, max(facing, 0.0)) * caustics(place, size);
  vec3 around = mix(vec3(0.30, 0.42, 0.45), vec3(0.62, 0.92, 1.05), 0.5 + 0.5 * normal.y) * open;
  vec3 bounced = vec3(0.34, 0.36, 0.27) * max(-normal.y, 0.0) * open;
  return albedo * (direct + around + bounced);
}
vec3 shown_as(vec3 light) { return pow(1.0 - exp(-1.15 * light), vec3(1.0 / 2.2)); }`;

export const BODY_VERTEX = `#version 300 es
uniform mat4 view, projection;
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 skin;   // ridge, youth, openness
layout(location = 3) in vec3 color;
out vec3 at, facing, kind, paint;
void main() {
  at = place;
  facing = normal;
  kind = skin;
  paint = color;
  gl_Position = projection * view * vec4(place, 1);
}`;

export const BODY_FRAGMENT = `#version 300 es
precision highp float;
uniform vec3 eye, second;
uniform float cup, relief, size;
uniform int matter;  // 0 cups, 1 valleys, 2 pits of a sponge
in vec3 at, facing, kind, paint;
out vec4 shown;
${LIGHT}
vec3 corner(vec3 p) {
  p = vec3(dot(p, vec3(127.1, 311.7, 74.7)), dot(p, vec3(269.5, 183.3, 246.1)), dot(p, vec3(113.5, 271.9, 124.6)));
  return fract(sin(p) * 43758.5453);
}
/** From the nearest middle of a cup, in cups. */
vec3 from_cup(vec3 p) {
  vec3 i = floor(p - 0.5), best = vec3(9);
  for (int k = 0; k < 8; ++k) {
    vec3 cell = i + vec3(k & 1, k >> 1 & 1, k >> 2);
    vec3 d = p - cell - 0.25 - 0.5 * corner(cell);
    if (dot(d, d) < dot(best, best)) best = d;
  }
  return best;
}
vec3 linear(vec3 c) { return pow(c, vec3(2.2)); }
void main() {
  vec3 normal = normalize(facing);
  if (dot(normal, eye - at) < 0.0) normal = -normal;
  vec3 C = linear(paint), D = linear(second);
  vec3 albedo;
  float fine = 1.0 - smoothstep(0.25, 0.7, length(fwidth(at / cup)));
  vec3 away = from_cup(at / cup);
  away -= normal * dot(away, normal);
  float far = length(away);
  if (matter == 1) {
    float t = kind.x;
    vec3 slope = mix(D * 0.45 + C * 0.5, C, smoothstep(0.45, 0.75, t));
    albedo = mix(mix(D * 0.7, D, smoothstep(0.0, 0.2, t)), slope, smoothstep(0.18, 0.5, t));
    albedo = mix(albedo, C * 1.25 + 0.02, smoothstep(0.72, 1.0, t));
    normal = normalize(normal - 0.12 * relief * fine * away);
  } else {
    C = mix(C, C * 0.55 + vec3(0.93, 0.85, 0.70) * 0.42, 0.8 * kind.y);
    float pit = matter == 2 ? 0.62 : 1.0;
    vec3 cups = mix(D * 0.8, C * 0.78 + D * 0.15, smoothstep(0.05, 0.22, far / pit));
    cups = mix(cups, C * 1.2 + 0.02, smoothstep(0.18, 0.30, far / pit) * (1.0 - smoothstep(0.32, 0.5, far)));
    albedo = mix(C * 0.9 + D * 0.08, cups, fine);
    float rise = smoothstep(0.02, 0.2, far) * (1.0 - smoothstep(0.24, 0.34, far)) - 0.6 * smoothstep(0.34, 0.5, far);
    normal = normalize(normal - 0.5 * relief * fine * rise * away / max(far, 0.02));
  }
  float open = matter == 1 ? kind.z * mix(0.45, 1.0, smoothstep(0.0, 0.6, kind.x)) : kind.z;
  vec3 light = under_water(albedo, normal, at, open, size);
  vec3 middle = normalize(sun + normalize(eye - at));
  light += 0.10 * pow(max(dot(normal, middle), 0.0), 24.0) * lit(at, 1.0) * vec3(0.9, 1.0, 1.0);
  shown = vec4(shown_as(light), 1);
}`;

export const SAND_VERTEX = `#version 300 es
uniform mat4 view, projection;
uniform float half_side;
layout(location = 0) in vec2 corner;  // -1..1
layout(location = 1) in vec2 light;
out vec2 flat_at;
out vec3 at;
out float open;
void main() {
  flat_at = corner;
  at = vec3(half_side * corner.x, 0, half_side * corner.y);
  open = light.y;
  gl_Position = projection * view * vec4(at, 1);
}`;
export const SAND_FRAGMENT = `#version 300 es
precision highp float;
uniform float size;
in vec2 flat_at;
in vec3 at;
in float open;
out vec4 shown;
${LIGHT}
void main() {
  float alpha = 1.0 - smoothstep(0.25, 1.0, length(flat_at));
  vec2 grain = floor(at.xz / size * 260.0);
  float ridge = 0.5 + 0.5 * sin(at.x / size * 21.0 + 1.8 * sin(at.z / size * 6.0) + 0.8 * sin(at.x / size * 4.0));
  vec3 sand = vec3(0.66, 0.58, 0.46) * (0.93 + 0.1 * hash(grain) + 0.05 * ridge);
  vec3 normal = normalize(vec3(0.05 * cos(at.x / size * 21.0 + 1.8 * sin(at.z / size * 6.0)), 1, 0));
  vec3 light = under_water(sand * sand, normal, at, open * open, size);
  shown = vec4(shown_as(light) * alpha, alpha);
}`;

/** What the sun sees: only how far away it is. */
export const SHADOW_VERTEX = `#version 300 es
uniform mat4 shadow_view;
layout(location = 0) in vec3 place;
void main() {
  gl_Position = shadow_view * vec4(place, 1);
}`;
export const SHADOW_FRAGMENT = `#version 300 es
precision highp float;
void main() {}`;
