#include "foliage/mosaic.h"

#include <algorithm>
#include <cmath>

#include "core/cell_grid.h"

namespace frond {

namespace {

Disc placed(const Disc& disc, const MosaicSite& site, const Quat& turn) {
  return {site.foot + turn * (disc.middle * site.size), turn * disc.normal, disc.radius * site.size};
}

/// How much of a disc earlier ones cover, seen along its normal.
float covered_area(const Disc& disc, std::span<const Disc> others, float depth) {
  float sum = 0, deep = depth * disc.radius;
  for (const Disc& other : others) {
    Vec3 offset = other.middle - disc.middle;
    float touch = disc.radius + other.radius, far = glm::dot(offset, offset);
    if (far > touch * touch + deep * deep) continue;
    float high = glm::dot(offset, disc.normal), facing = glm::dot(other.normal, disc.normal);
    if (std::abs(high) > deep || facing <= 0.2f) continue;
    float apart = std::sqrt(std::max(far - high * high, 0.0f));
    if (apart < touch) sum += facing * static_cast<float>(lens_area(disc.radius, other.radius, apart));
  }
  return sum;
}

struct Sizes {
  float reach = 0, disc = 0;  // of the farthest rim of any form, and of its largest disc
};

Sizes sizes_of(std::span<const LeafForm> forms) {
  Sizes s;
  for (const LeafForm& form : forms)
    for (const Disc& d : form.discs) {
      s.reach = std::max(s.reach, glm::length(d.middle) + d.radius);
      s.disc = std::max(s.disc, d.radius);
    }
  return s;
}

/// acos(x) - x sqrt(1 - x^2) to 1e-7 (Abramowitz and Stegun 1964, 4.4.46): half the segment that a chord cuts
/// off a circle of radius 1, x from its middle.
double segment(double x) {
  double a = std::min(std::abs(x), 1.0), root = std::sqrt(1 - a);
  constexpr double kTerms[] = {-0.0012624911, 0.0066700901, -0.0170881256, 0.0308918810,
                               -0.0501743046, 0.0889789874, -0.2145988016, 1.5707963050};
  double sum = 0;
  for (double term : kTerms) sum = sum * a + term;
  double half = root * (sum - a * std::sqrt(1 + a));
  return x < 0 ? kPi - half : half;
}

}  // namespace

double lens_area(double r, double s, double d) {
  if (d >= r + s) return 0;
  if (d <= std::abs(r - s)) return kPi * std::min(r, s) * std::min(r, s);
  return r * r * segment((d * d + r * r - s * s) / (2 * d * r)) +
         s * s * segment((d * d + s * s - r * r) / (2 * d * s));
}

Quat leaf_turn(Vec3 normal, Vec3 tip) {
  Vec3 along = tip - glm::dot(tip, normal) * normal;
  if (glm::dot(along, along) < 1e-8f)
    along = std::abs(normal.y) < 0.9f ? Vec3(0, 1, 0) - normal.y * normal : Vec3(1, 0, 0) - normal.x * normal;
  along = glm::normalize(along);
  return glm::normalize(glm::quat_cast(glm::mat3(glm::cross(along, normal), along, normal)));
}

std::vector<LaidLeaf> lay_leaves(std::span<const MosaicSite> sites, std::span<const LeafForm> forms,
                                 const MosaicOptions& options) {
  std::vector<LaidLeaf> laid;
  Sizes sizes = sizes_of(forms);
  float largest = 0;
  for (const MosaicSite& site : sites) largest = std::max(largest, site.size);
  if (!(largest * sizes.disc > 0)) return laid;
  CellGrid grid(2 * largest * sizes.disc);
  std::vector<float> areas;
  for (const LeafForm& form : forms) {
    areas.push_back(0);
    for (const Disc& disc : form.discs) areas.back() += static_cast<float>(kPi) * disc.radius * disc.radius;
  }
  std::vector<Disc> discs, near;  // of all leaves that are laid, and of those about a site
  int turns = std::max(1, options.turns);
  for (std::uint32_t i = 0; i < sites.size() && laid.size() < options.most; ++i) {
    const MosaicSite& site = sites[i];
    float reach = site.size * sizes.reach + largest * sizes.disc;
    near.clear();
    grid.each(site.foot - reach, site.foot + reach, [&](std::uint32_t d) {
      if (glm::distance(discs[d].middle, site.foot) <= reach) near.push_back(discs[d]);
    });
    LaidLeaf best{i, site.first};
    float least = INFINITY;
    Quat preferred = leaf_turn(site.normal, site.tip);
    for (int t = 0; t < turns && least > 0; ++t) {
      // 0, then to one side and the other, farther each time.
      double share = turns > 1 ? ((t + 1) / 2) * (t % 2 ? 1.0 : -1.0) / (turns / 2) : 0;
      Quat turn = preferred * glm::angleAxis(static_cast<float>(options.swing * share), Vec3(0, 0, 1));
      for (std::uint32_t k = 0; k < site.forms && least > 0; ++k) {
        std::uint32_t f = site.first + (site.prefer + k) % site.forms;
        float covered = 0, area = areas[f] * site.size * site.size;
        for (const Disc& disc : forms[f].discs) {
          covered += covered_area(placed(disc, site, turn), near, static_cast<float>(options.depth)) / area;
          if (covered >= least) break;
        }
        if (covered >= least) continue;
        least = covered;
        best.form = f, best.turn = turn, best.covered = covered;
      }
    }
    if (least > options.overlap) continue;
    laid.push_back(best);
    for (const Disc& disc : forms[best.form].discs) {
      discs.push_back(placed(disc, site, best.turn));
      grid.add(discs.back().middle, static_cast<std::uint32_t>(discs.size() - 1));
    }
  }
  return laid;
}

}  // namespace frond
