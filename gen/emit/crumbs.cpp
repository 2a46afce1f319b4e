#include "emit/crumbs.h"

#include <charconv>
#include <cmath>
#include <map>
#include <mutex>

#include "core/text.h"
#include "emit/crumbling.h"

namespace frond {

std::vector<Crumb> crumbs_of(const Look& look, const Model& model) {
  float tall = 0;
  for (const Vec3& at : model.skeleton.position) tall = std::max(tall, glm::length(at));
  for (const Vec3& at : model.organs.position) tall = std::max(tall, glm::length(at));
  for (const Vec3& at : model.blades.surface.position) tall = std::max(tall, glm::length(at));
  if (tall == 0) tall = 1;
  constexpr int kFine = 4;  // to a cell's side, to see what lies before one another in it
  float cell = std::max(tall / 24, 0.02f) / kFine;
  // The sums do not depend on the order in which they are made: whole numbers.
  struct Sum {
    std::array<std::int64_t, 8> of{};  // area; area times place, colour, bulk
  };
  struct IntoMap {
    float cell;
    std::map<std::array<int, 4>, Sum>& sums;
    std::mutex& in_work;
    void add(Vec3 at, float area, Vec3 albedo, Facing, float bulk) const {
      glm::ivec3 k = glm::ivec3(glm::floor(at / cell));
      double quanta = area / (cell * cell) * 1e6;
      std::lock_guard lock(in_work);
      Sum& sum = sums[{k.x, k.y, k.z, bulk > 0 ? 1 : 0}];
      sum.of[0] += std::llround(quanta);
      for (std::size_t c = 0; c < 3; ++c) {
        sum.of[1 + c] += std::llround(quanta * at[static_cast<int>(c)] * 1e3);
        sum.of[4 + c] += std::llround(quanta * albedo[static_cast<int>(c)] * 1e3);
      }
      sum.of[7] += std::llround(quanta * std::min(bulk, 100.0f) * 1e3);
    }
    float step(Vec3) const { return cell; }
  };
  std::map<std::array<int, 4>, Sum> sums;
  std::mutex in_work;
  crumble(IntoMap{cell, sums, in_work}, look, model);
  struct Whole {
    Sum sum;
    std::array<float, kFine * kFine * kFine> depth{};
  };
  std::map<std::array<int, 4>, Whole> wholes;
  for (const auto& [key, sum] : sums) {
    std::array<int, 4> to = key;
    std::size_t in = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      to[c] = static_cast<int>(std::floor(static_cast<float>(key[c]) / kFine));
      in = in * kFine + static_cast<std::size_t>(key[c] - to[c] * kFine);
    }
    Whole& whole = wholes[to];
    for (std::size_t i = 0; i < sum.of.size(); ++i) whole.sum.of[i] += sum.of[i];
    whole.depth[in] = static_cast<float>(static_cast<double>(sum.of[0]) * (key[3] == 1 ? 0.25e-6 : 0.5e-6));
  }
  std::vector<Crumb> list;
  for (const auto& [key, whole] : wholes) {
    const Sum& sum = whole.sum;
    if (sum.of[0] <= 0) continue;
    double total = static_cast<double>(sum.of[0]);
    auto share = [&](std::size_t i) {
      return static_cast<float>(static_cast<double>(sum.of[i]) / total / 1e3);
    };
    float through = 0, all = 0;
    constexpr std::size_t kColumns = kFine * kFine;
    for (std::size_t along = 1; along < whole.depth.size(); along *= kFine) {
      for (std::size_t i = 0; i < whole.depth.size(); ++i) {
        if (i / along % kFine != 0) continue;
        float depth = 0;
        for (std::size_t k = 0; k < kFine; ++k) depth += whole.depth[i + k * along];
        through += std::exp(-depth);
        all += depth;
      }
    }
    float apart = -std::log(std::max(through / (3 * kColumns), 1e-6f)) / (all / (3 * kColumns));
    list.push_back({Vec3(share(1), share(2), share(3)), apart * static_cast<float>(total / 1e6) * cell * cell,
                    kFine * cell, Vec3(share(4), share(5), share(6)), share(7)});
  }
  return list;
}

std::string crumbs_text(const std::vector<Crumb>& crumbs) {
  std::string text = "// " + number_text(static_cast<double>(crumbs.size())) + " crumbs\n";
  for (const Crumb& crumb : crumbs) {
    append_list(text, 3, crumb.at.x, crumb.at.y, crumb.at.z);
    text += ',';
    append(text, crumb.area, 6);
    text += ',';
    append(text, crumb.wide, 3);
    text += ',';
    append_list(text, 3, crumb.albedo.x, crumb.albedo.y, crumb.albedo.z, crumb.bulk);
    text += '\n';
  }
  return text;
}

std::vector<Crumb> read_crumbs(std::string_view text) {
  std::vector<Crumb> list;
  text.remove_prefix(std::min(text.size(), text.find('\n')));
  const char* at = text.data();
  const char* end = text.data() + text.size();
  while (at < end) {
    std::array<float, 9> value{};
    for (float& one : value) {
      if (at == end || ++at == end) return list;  // past what parts it from the last
      auto [next, error] = std::from_chars(at, end, one);
      if (error != std::errc{}) return list;
      at = next;
    }
    list.push_back(
        {{value[0], value[1], value[2]}, value[3], value[4], {value[5], value[6], value[7]}, value[8]});
  }
  return list;
}

}  // namespace frond
