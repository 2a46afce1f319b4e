#include "pruning/address.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <tuple>

#include "core/read_as.h"

namespace frond {

namespace {

constexpr int kMostDigits = 9;
constexpr double kShares = 1e6;  // steps of an axis that texts tell apart

/// A number from 1 that the text begins with, which is taken off; 0 if there is none.
int consume_number(std::string_view& text) {
  int number = 0;
  std::size_t digits = 0;
  while (digits < text.size() && text[digits] >= '0' && text[digits] <= '9') ++digits;
  if (digits == 0 || digits > kMostDigits) return 0;
  std::from_chars(text.data(), text.data() + digits, number);
  text.remove_prefix(digits);
  return number;
}

bool consume(std::string_view& text, char c) {
  if (!text.starts_with(c)) return false;
  text.remove_prefix(1);
  return true;
}

/// What an address without its last `less` axes names, for messages.
std::string name_of(Address address, std::size_t less) {
  address.axes.resize(address.axes.size() - less);
  address.share = 0;
  if (address.axes.empty()) return address.stem == 1 ? "the stem" : fmt::format("stem {}", address.stem);
  return text(address);
}

/// "3 branches", or of what is numbered with gaps "3 branches, numbers 4 to 17".
std::string told(std::vector<std::int32_t> numbers) {
  if (numbers.empty()) return "no branches";
  std::ranges::sort(numbers);
  std::string branches = fmt::format("{} branch{}", numbers.size(), numbers.size() == 1 ? "" : "es");
  if (numbers.back() == std::ssize(numbers)) return branches;
  return branches + fmt::format(", numbers {} to {}", numbers.front(), numbers.back());
}

/// The first node of the axis that an address names.
Result<std::int32_t> find_axis(const Branching& plant, std::span<const std::int32_t> starts,
                               const Address& address) {
  std::int32_t axis = Skeleton::kRoot;
  for (std::size_t level = 0; level <= address.axes.size(); ++level) {
    const int wanted = level == 0 ? address.stem : address.axes[level - 1];
    std::int32_t found = Skeleton::kRoot;
    std::vector<std::int32_t> others;
    for (std::size_t i = 0; i < plant.parent.size() && found == Skeleton::kRoot; ++i) {
      const std::int32_t p = plant.parent[i], number = plant.axes[i].number;
      if (number <= 0 || (p == Skeleton::kRoot ? p : starts[p]) != axis) continue;
      if (number == wanted) found = static_cast<std::int32_t>(i);
      others.push_back(number);
    }
    if (found != Skeleton::kRoot) {
      axis = found;
      continue;
    }
    if (level == 0) return error_at("", "finds no stem: there are {}", others.size());
    return error_at("", "finds no branch: {} has {}", name_of(address, address.axes.size() - level + 1),
                    told(others));
  }
  return axis;
}

}  // namespace

Result<Address> parse_address(std::string_view given) {
  std::string_view rest = given;
  auto fault = [&] { return error_at("", "found \"{}\"; expected {}", given, kAddressForm); };
  Address address;
  bool more = !rest.empty() && rest.front() != ':';
  if (consume(rest, '#')) {
    if (address.stem = consume_number(rest); address.stem == 0) return fault();
    more = consume(rest, '/');
  }
  while (more) {
    int number = consume_number(rest);
    if (number == 0) return fault();
    address.axes.push_back(number);
    more = consume(rest, '/');
  }
  if (consume(rest, ':')) {
    address.share = consume_as<decltype(address.share)>(rest).value_or(-1);
    if (!(address.share >= 0 && address.share <= 1)) return fault();
  }
  if (!rest.empty()) return fault();
  return address;
}

std::string text(const Address& address) {
  std::string text;
  if (address.stem != 1) text = fmt::format("#{}", address.stem);
  for (int axis : address.axes) text += fmt::format("{}{}", text.empty() ? "" : "/", axis);
  if (address.share > 0) text += fmt::format(":{}", std::round(address.share * kShares) / kShares);
  return text;
}

std::vector<AxisNode> axis_nodes(const Skeleton& s) {
  const std::size_t n = s.size();
  std::vector<std::int32_t> next(n, Skeleton::kRoot), start(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::int32_t p = s.parent[i];
    if (p != Skeleton::kRoot && (next[p] == Skeleton::kRoot || s.order[i] < s.order[next[p]]))
      next[p] = static_cast<std::int32_t>(i);
  }
  std::vector<float> along(n), length(n);
  std::vector<std::tuple<std::int32_t, float, std::int32_t>> leaving;  // the axis it leaves, where, it
  for (std::size_t i = 0; i < n; ++i) {
    const auto node = static_cast<std::int32_t>(i), p = s.parent[i];
    const bool continues = p != Skeleton::kRoot && next[p] == node;
    start[i] = continues ? start[p] : node;
    if (p != Skeleton::kRoot)
      along[i] = (continues ? along[p] : 0) + glm::distance(s.position[p], s.position[i]);
    length[start[i]] = std::max(length[start[i]], along[i]);
    if (continues) continue;
    leaving.emplace_back(p == Skeleton::kRoot ? p : start[p], p == Skeleton::kRoot ? 0 : along[p], node);
  }
  std::ranges::sort(leaving);
  std::vector<AxisNode> axes(n);
  for (std::size_t k = 0; k < leaving.size(); ++k) {
    auto [on, at, node] = leaving[k];
    const bool first = k == 0 || std::get<0>(leaving[k - 1]) != on;
    axes[node].number = first ? 1 : axes[std::get<2>(leaving[k - 1])].number + 1;
  }
  for (std::size_t i = 0; i < n; ++i) axes[i].share = length[start[i]] > 0 ? along[i] / length[start[i]] : 0;
  return axes;
}

std::vector<AxisNode> axis_nodes(const Model& model) {
  return model.axes.empty() ? axis_nodes(model.skeleton) : model.axes;
}

std::vector<std::int32_t> axis_starts(const Branching& plant) {
  std::vector<std::int32_t> starts(plant.parent.size());
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const bool begins = plant.axes[i].number != 0 || plant.parent[i] == Skeleton::kRoot;
    starts[i] = begins ? static_cast<std::int32_t>(i) : starts[plant.parent[i]];
  }
  return starts;
}

Result<BranchPlace> find_place(const Branching& plant, std::span<const std::int32_t> starts,
                               const Address& address) {
  Result<std::int32_t> axis = find_axis(plant, starts, address);
  if (!axis) return axis.errors();
  BranchPlace place{*axis, plant.parent[*axis] == Skeleton::kRoot ? 1.0f : 0.0f};
  const auto share = static_cast<float>(address.share);
  float below = 0;
  for (auto i = static_cast<std::size_t>(*axis); i < starts.size() && share > 0; ++i) {
    if (starts[i] != *axis) continue;
    const float above = plant.axes[i].share;
    place = {static_cast<std::int32_t>(i), 1};
    if (above >= share - 1 / static_cast<float>(kShares)) {
      place.within = above > below ? std::min((share - below) / (above - below), 1.0f) : 1;
      break;
    }
    below = above;
  }
  return place;
}

std::optional<Address> address_of(const Branching& plant, BranchPlace place) {
  std::int32_t i = place.node;
  bool named = true;
  for (std::int32_t k = i; k != Skeleton::kRoot; k = plant.parent[k])
    if (plant.axes[k].number < 0) i = plant.parent[k], named = false;
  if (i == Skeleton::kRoot) return std::nullopt;
  Address address;
  const float above = plant.axes[i].share;
  const bool first = plant.axes[i].number > 0;
  const float below = first ? 0 : plant.axes[plant.parent[i]].share;
  address.share = named && plant.parent[i] != Skeleton::kRoot
                      ? std::clamp(below + (above - below) * place.within, 0.0f, 1.0f)
                      : above;
  for (; i != Skeleton::kRoot; i = plant.parent[i]) {
    if (plant.axes[i].number <= 0) continue;
    if (plant.parent[i] == Skeleton::kRoot)
      address.stem = plant.axes[i].number;
    else
      address.axes.push_back(plant.axes[i].number);
  }
  std::ranges::reverse(address.axes);
  return address;
}

}  // namespace frond
