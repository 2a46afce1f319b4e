#include "organisms/ivy/ivy_forms.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace frond {

namespace {

constexpr std::array<double, 3> kStalks{0.75, 0.45, 1.15};  // shares of the blade's length
constexpr std::array<double, 2> kRises{radians(58.0), radians(32.0)};
constexpr double kLeastDroop = 0.12, kDroopStep = 0.035;  // by petiole; shares of the blade's length

// The petiole of a picture is as long as its stalk is, so that its petioles differ in how steeply they rise.
constexpr std::array<double, kPetioles> kPictureRises{radians(58.0), radians(38.0), radians(48.0),
                                                      radians(25.0), radians(82.0), radians(68.0)};

IvyLeafShape leaf_shape(std::uint32_t form, int detail) {
  IvyLeafShape shape;
  shape.form = static_cast<IvyForm>(form / kPetioles);
  std::uint32_t petiole = form % kPetioles;
  shape.stalk = kStalks[petiole / 2], shape.rise = kRises[petiole % 2];
  shape.detail = detail;
  shape.droop = kLeastDroop + kDroopStep * petiole;
  if (shape.form == IvyForm::heart) shape.wave *= 0.5;
  return shape;
}

/// The share of a picture's length below its blade, or below the first leaves of a sprig.
double picture_stalk(const LeafLook& look) {
  LeafImage image = leaf_image(look, 0);
  if (!image.sprig) return image.outline.stalk;
  double lowest = 1;
  for (const LeafPlace& leaf : sprig_places(image.sprigs)) lowest = std::min<double>(lowest, leaf.foot.y);
  return 0.8 * lowest;
}

/// A picture whose stalk rises from where it is held and bends over to the blade.
Surface pictured_leaf(const LeafLook& look, std::uint32_t form, int points) {
  Surface leaf = leaf_mesh(leaf_image(look, 0), points, look.fold, look.bend, {look.curl, 2.0 * form});
  auto stalk = static_cast<float>(picture_stalk(look));
  double rise = kPictureRises[form % kPetioles];
  auto ahead = static_cast<float>(std::cos(rise)), up = static_cast<float>(std::sin(rise));
  for (Vec3& p : leaf.position) {
    float along = std::min(p.y, stalk);
    p.y += (ahead - 1) * along, p.z += up * along;
  }
  set_normals(leaf);
  return leaf;
}

/// A circle about as large as what a picture's mesh covers.
Disc disc_of(const Surface& leaf) {
  Vec3 low(1e9f), high(-1e9f);
  float area = 0;
  for (auto [a, b, c] : leaf.triangle) {
    Vec3 p = leaf.position[a], q = leaf.position[b], r = leaf.position[c];
    area += 0.5f * std::abs((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x));
  }
  for (const Vec3& p : leaf.position) low = glm::min(low, p), high = glm::max(high, p);
  return {{0, std::lerp(low.y, high.y, 0.55f), high.z}, {0, 0, 1}, std::sqrt(area / float(kPi))};
}

}  // namespace

std::vector<LeafForm> leaf_forms(const IvyLeaves& leaves) {
  std::vector<LeafForm> forms;
  for (std::uint32_t i = 0; i < (leaves.picture ? 1 : kIvyForms) * kPetioles; ++i) {
    if (leaves.picture) {
      forms.push_back({{disc_of(leaf_of(leaves, i, 0))}});
      continue;
    }
    LeafDisc disc = ivy_disc(leaf_shape(i, 0));
    forms.push_back({{{disc.middle, Vec3(0, 0, 1), disc.radius}}});
  }
  return forms;
}

Surface leaf_of(const IvyLeaves& leaves, std::uint32_t form, int detail) {
  if (!leaves.picture) return ivy_leaf_surface(leaf_shape(form, detail));
  constexpr int kFarPoints = 4;
  int points = leaves.picture->detail;
  return pictured_leaf(*leaves.picture, form, detail > 0 ? points : std::min(points, kFarPoints));
}

double stalk_of(const IvyLeaves& leaves, std::uint32_t form) {
  return leaves.picture ? picture_stalk(*leaves.picture) : leaf_shape(form, 0).stalk;
}

Surface felt(const IvyLeaves& leaves, Surface leaf) {
  if (!leaves.picture) return leaf;
  // As on ivy, u is above 1 on the petiole. The blade of a picture begins where its stalk has come to its
  // height.
  PictureFrame frame = picture_frame(leaf_image(*leaves.picture, 0));
  double above = picture_stalk(*leaves.picture);
  for (Vec2& uv : leaf.uv)
    if (frame.low + static_cast<double>(uv.y) * (frame.high - frame.low) < above) uv.x += 2;
  return leaf;
}

}  // namespace frond
