#include "bake/photometry.h"

#include <algorithm>
#include <cmath>

#include "core/linear.h"

namespace frond {

namespace {

constexpr float kDark = 1e-5f;  // light by which no direction can be told

/// The last columns of a picture blended with the first.
VecGrid seamless_across(const VecGrid& larger, int wide) {
  VecGrid made(wide, larger.height);
  int edge = larger.width - wide;
  Vec3 mean(0);
  for (const Vec3& v : larger.data) mean += v;
  mean /= static_cast<float>(larger.data.size());
  for (int y = 0; y < made.height; ++y)
    for (int x = 0; x < wide; ++x) {
      made.at(x, y) = larger.at(x, y);
      if (x >= edge) continue;
      float own = (static_cast<float>(x) + 0.5f) / static_cast<float>(edge), other = 1 - own;
      Vec3 sum = own * (larger.at(x, y) - mean) + other * (larger.at(x + wide, y) - mean);
      made.at(x, y) = mean + sum / std::sqrt(own * own + other * other);
    }
  return made;
}

}  // namespace

VecGrid part_of(const LinearRaster& raster, double white, int left, int top, int wide, int high) {
  VecGrid part(wide, high);
  auto factor = static_cast<float>(1 / (65535 * white));
  for (int y = 0; y < high; ++y) {
    const std::uint16_t* row =
        &raster.data[3 * (static_cast<std::size_t>(top + y) * static_cast<std::size_t>(raster.width) +
                          static_cast<std::size_t>(left))];
    for (int x = 0; x < wide; ++x, row += 3) part.at(x, y) = factor * Vec3(row[0], row[1], row[2]);
  }
  return part;
}

void fill_black(VecGrid& light) {
  const VecGrid seen = light;
  auto lit = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < seen.width && y < seen.height && seen.at(x, y) != Vec3(0);
  };
  constexpr int kSteps[][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  for (int y = 0; y < light.height; ++y)
    for (int x = 0; x < light.width; ++x)
      for (int far = 1; light.at(x, y) == Vec3(0) && far < std::max(light.width, light.height); ++far)
        for (auto [dx, dy] : kSteps)
          if (lit(x + far * dx, y + far * dy)) light.at(x, y) = seen.at(x + far * dx, y + far * dy);
}

VecGrid seamless(const VecGrid& larger, int wide, int high) {
  return transposed(seamless_across(transposed(seamless_across(larger, wide)), high));
}

std::array<Vec3, 3> lamps() {
  constexpr float kTilt = 0.70710678f;
  std::array<Vec3, 3> towards;
  for (int k = 0; k < 3; ++k) {
    auto angle = static_cast<float>(kPi / 2 + 2 * kPi * k / 3);
    towards[static_cast<std::size_t>(k)] = {kTilt * std::cos(angle), kTilt * std::sin(angle), kTilt};
  }
  return towards;
}

VecGrid normals_of(const VecGrid& ambient, const std::array<VecGrid, 3>& lit) {
  VecGrid normals(ambient.width, ambient.height);
  std::array<Vec3, 3> towards = lamps();
  for (std::size_t i = 0; i < normals.data.size(); ++i) {
    // The lamps stand evenly round z: the inverse of their matrix is its transpose, but for a factor of z.
    Vec3 n(0);
    for (std::size_t k = 0; k < 3; ++k) {
      Vec3 more = lit[k].data[i] - ambient.data[i];
      n += std::max(0.0f, more.x + more.y + more.z) * towards[k] * Vec3(1, 1, 0.5f);
    }
    normals.data[i] = glm::length(n) > kDark ? glm::normalize(n) : Vec3(0, 0, 1);
  }
  return normals;
}

Raster normal_raster(const VecGrid& normals) {
  Raster made(normals.width, normals.height, 3);
  for (std::size_t i = 0; i < normals.data.size(); ++i) {
    Vec3 n = normals.data[i];
    n.z = std::max(n.z, 0.1f);  // blending may have turned it away
    n = glm::normalize(n);
    for (std::size_t c = 0; c < 3; ++c) made.data[3 * i + c] = to_byte(0.5 + 0.5 * n[static_cast<int>(c)]);
  }
  return made;
}

Raster color_raster(const VecGrid& light) {
  Raster made(light.width, light.height, 3);
  for (std::size_t i = 0; i < light.data.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      made.data[3 * i + c] =
          to_byte(encoded(std::clamp(static_cast<double>(light.data[i][static_cast<int>(c)]), 0.0, 1.0)));
  return made;
}

Raster roughness_of(const Raster& normals, double rough) {
  Raster made(std::max(1, normals.width / 2), std::max(1, normals.height / 2), 3);
  for (int y = 0; y < made.height; ++y)
    for (int x = 0; x < made.width; ++x) {
      Vec3 sum(0);
      for (int corner = 0; corner < 4; ++corner) {
        int u = std::min(2 * x + corner % 2, normals.width - 1),
            v = std::min(2 * y + corner / 2, normals.height - 1);
        for (int c = 0; c < 3; ++c) sum[c] += static_cast<float>(normals.at(u, v, c)) / 127.5f - 1;
      }
      // The shorter the mean, the wider the normals are spread: about a variance of slopes.
      double length = std::clamp(static_cast<double>(glm::length(sum)) / 4, 0.1, 1.0);
      double spread = (1 - length) / length, alpha = rough * rough;
      // Green is the roughness; blue, the share of metal, is nothing.
      made.data[made.index(x, y, 1)] = to_byte(std::sqrt(std::sqrt(std::min(1.0, alpha * alpha + spread))));
    }
  return made;
}

}  // namespace frond
