#include "images/venation.h"

#include <algorithm>
#include <cmath>

#include "images/main_veins.h"

namespace frond {

namespace {

constexpr double kThird = 0.085;  // sources of the veins of third order, in the leaf's unit
constexpr double kFiner = 0.52;   // from order to order
constexpr int kOrders = 3;        // of them
constexpr double kLine = 0.12;    // half the width of parallel veins, as a share of how far apart they are
constexpr double kCross = 1.6;    // between veins across parallel ones, as a share of how far apart these are
constexpr double kMidrib = 0.013,
                 kMain = 0.011;  // half the width of a main vein at its foot: of one, of several

}  // namespace

Veins grow_veins(const LeafOutline& outline, double finest, Seed seed) {
  const Venation& v = outline.venation;
  Lamina blade(outline);
  VeinTree tree(blade);
  lay_main_veins(outline, blade, tree);
  // Blades that are wider than long have a coarser net, so that it has no more veins.
  finest *= std::max(1.0f, blade.wide());
  auto grow = [&](int k, double apart, double clear) {
    tree.colonize(apart, clear, static_cast<std::uint8_t>(3 + k), v.loops,
                  seed.child("order", static_cast<std::uint64_t>(k)));
  };
  double width = v.pattern == VeinPattern::pinnate ? kMidrib : kMain;
  if (v.pattern == VeinPattern::parallel) {
    // Veins side by side are tied by a few short ones across.
    double gap = blade.wide() / (v.secondaries + 0.6);
    width = std::min(width, kLine * gap * std::cbrt(2 * v.secondaries + 1));
    if (v.loops && gap > 0.5 * finest) grow(0, std::max(kCross * gap / v.density, finest), 0.4 * gap);
  } else if (v.pattern != VeinPattern::dichotomous) {
    double apart = kThird / v.density;
    // A round that would be finer is as fine as it may be, so that a denser net never has fewer veins.
    for (int k = 0; k < kOrders; ++k, apart *= kFiner) {
      const double now = std::max(apart, finest);
      grow(k, now, 0.5 * now);
      if (now > apart) break;
    }
  }
  return tree.take(width);
}

std::vector<SecondaryLine> secondary_lines(const LeafOutline& outline) {
  std::vector<SecondaryLine> lines;
  if (outline.venation.pattern != VeinPattern::pinnate) return lines;
  Lamina blade(outline);
  VeinTree tree(blade);
  lay_main_veins(outline, blade, tree);
  const Veins& v = tree.veins();
  // A secondary is a run of points of second order whose first has a parent of first order; the arches that
  // join them begin elsewhere.
  bool runs = false;
  for (std::size_t i = 1; i < v.size(); ++i) {
    auto parent = static_cast<std::size_t>(v.parent[i]);
    const bool begins = v.order[i] == 2 && v.order[parent] == 1;
    runs = begins || (runs && v.order[i] == 2 && parent + 1 == i);
    if (begins) lines.push_back({v.point[parent], v.point[i]});
    if (runs) lines.back().to = v.point[i];
  }
  std::ranges::stable_sort(lines, {}, [](const SecondaryLine& l) { return l.from.y; });
  return lines;
}

}  // namespace frond
