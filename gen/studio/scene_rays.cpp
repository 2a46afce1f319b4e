#include <fmt/format.h>

#include <array>

#include "studio/scenes.h"

// What tools of the view ask about a scene by rays: branches that are picked, and places that are drawn on.

namespace frond {

template <class T, class Make>
Result<std::shared_ptr<const T>> Scenes::at_time(LruCache<T>& kept, const Doc& doc, const Json& question,
                                                 Make make) {
  const double time = question.value("time", 0.0);
  Result<Preset> preset = documents_.preset(doc);
  if (!preset) return preset.errors();
  const std::string name = fmt::format("{} {}", key_of(doc, *preset), time);
  if (std::shared_ptr<const T> found = kept.find(name)) return found;
  Result<std::shared_ptr<const Scene>> grown = scene(doc, std::move(*preset), [] { return false; });
  if (!grown) return grown.errors();
  Result<std::shared_ptr<const T>> made = make(*grown, time);
  if (made) kept.put(name, *made, (*made)->bytes());
  return made;
}

Answer Scenes::pick(const Doc& doc, const Json& question) {
  auto point = [&](const char* name) {
    auto p = question.at(name).get<std::array<float, 3>>();
    return Vec3(p[0], p[1], p[2]);
  };
  std::optional<Result<Address>> address;
  if (question.contains("at")) address = parse_address(question["at"].get<std::string>());
  if (address && !*address) return wrong(address->errors());
  std::optional<std::size_t> entry;
  if (question.contains("entry") && question["entry"].is_number_unsigned())
    entry = question["entry"].get<std::size_t>();
  auto stands = at_time(posed_, doc, question, [](const std::shared_ptr<const Scene>& scene, double time) {
    Result<PosedScene> made = posed(*scene, time);
    if (!made) return Result<std::shared_ptr<const PosedScene>>(made.errors());
    // What does not change is that of the scene.
    auto held =
        std::make_shared<std::pair<std::shared_ptr<const Scene>, PosedScene>>(scene, std::move(*made));
    return Result(std::shared_ptr<const PosedScene>(held, &held->second));
  });
  if (!stands) return wrong(stands.errors());
  if (address)
    return {200, picked_at(**stands, entry.value_or(0), question.value("plant", 0u), **address), {}};
  return {200, picked(**stands, point("from"), point("to"), entry), {}};
}

Answer Scenes::trace(const Doc& doc, const Json& question) {
  constexpr std::size_t kMostRays = 4096;
  auto rays = question.at("rays").get<std::vector<std::array<float, 6>>>();
  if (rays.size() > kMostRays) return {400, {{"error", "too many rays"}}, {}};
  std::optional<std::set<std::size_t>> on;
  if (question.contains("on") && question["on"].is_array()) on = numbers(question, "on");
  auto things = at_time(traced_, doc, question, traceable);
  if (!things) return wrong(things.errors());
  Json hits = Json::array();
  for (const auto& [x, y, z, dx, dy, dz] : rays)
    hits.push_back(hit_json(**things, {{x, y, z}, glm::normalize(Vec3(dx, dy, dz))}, on));
  return {200, {{"hits", std::move(hits)}}, {}};
}

}  // namespace frond
