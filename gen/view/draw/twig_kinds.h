#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/model.h"

// Which twigs are alike.

namespace frond {

inline constexpr std::size_t kManyOrgans = 30'000;  ///< of a plant that is worth a palette

/// What twigs are compared by.
struct TwigTraits {
  Quat axes{1, 0, 0, 0};  ///< its y leads from the joint to the middle of its organs, its z upward from there
  float area = 0;         ///< squares of its organs' scales, m2
  float count = 0;        ///< organs
  float reach = 0;        ///< metres from the joint to the middle of its organs
  float spread = 0;       ///< metres, deviation of its organs from their middle
  float flat = 0;         ///< share of that which is vertical, 0..1
  float rise = 0;         ///< radians above the horizon that y points to
  float bend = 0;         ///< cosine of the angle between its y and its first segment
  float color = 0;        ///< share of the turn of colours, mean
  std::uint64_t bears = 0;  ///< a bit for each prototype that it bears
};

/// Those of the twig that begins with a node. It bears one organ at least.
TwigTraits traits_of(const Model& model, std::int32_t node, std::span<const std::uint32_t> organs);

/// By what a twig is scaled so that it has as much area of leaves as another.
float scale_between(const TwigTraits& from, const TwigTraits& to);

/// The numbers of some twigs, by which each of the others is about like one of them (k-means; Lloyd 1982).
std::vector<std::uint32_t> choose_kinds(std::span<const TwigTraits> twigs);

/// For each twig which of `kept`, numbers of twigs, is most like it; one of these is like itself.
std::vector<std::uint32_t> nearest_kinds(std::span<const TwigTraits> twigs,
                                         std::span<const std::uint32_t> kept);

}  // namespace frond
