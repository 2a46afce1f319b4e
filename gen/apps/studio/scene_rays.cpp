#include <fmt/format.h>

#include "studio/scenes.h"

// What tools of the view ask about a scene by rays: branches that are picked, and places that are drawn on.

namespace frond {

namespace {

/// One of a place or of a way, in metres.
float coordinate(const Json& value) {
  constexpr double kFarthest = 1e9;
  return static_cast<float>(number(value, "a coordinate", -kFarthest, kFarthest));
}

}  // namespace

template <class T, class Make>
Result<std::shared_ptr<const T>> Scenes::at_time(LruCache<T>& kept, const Doc& doc, const Json& question,
                                                 Make make) {
  const double time = time_in(question);
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
    const Json& p = question.at(name);
    return Vec3(coordinate(p.at(0)), coordinate(p.at(1)), coordinate(p.at(2)));
  };
  std::optional<Result<Address>> address;
  if (question.contains("at")) address = parse_address(question["at"].get<std::string>());
  if (address && !*address) return wrong(address->errors());
  std::optional<std::size_t> entry;
  if (question.contains("entry") && question["entry"].is_number()) entry = index_in(question, "entry", 0);
  const std::size_t plant = index_in(question, "plant", 0);
  auto stands = at_time(posed_, doc, question, [](const std::shared_ptr<const Scene>& scene, double time) {
    Result<PosedScene> made = posed(*scene, time);
    if (!made) return Result<std::shared_ptr<const PosedScene>>(made.errors());
    // What does not change is that of the scene.
    auto held =
        std::make_shared<std::pair<std::shared_ptr<const Scene>, PosedScene>>(scene, std::move(*made));
    return Result(std::shared_ptr<const PosedScene>(held, &held->second));
  });
  if (!stands) return wrong(stands.errors());
  if (address) return {200, picked_at(**stands, entry.value_or(0), plant, **address)};
  return {200, picked(**stands, point("from"), point("to"), entry)};
}

Answer Scenes::trace(const Doc& doc, const Json& question) {
  constexpr std::size_t kMostRays = 4096;
  const Json& rays = question.at("rays");
  if (rays.size() > kMostRays) return refused(400, "too many rays");
  std::optional<std::set<std::size_t>> on;
  if (question.contains("on") && question["on"].is_array()) on = numbers(question, "on");
  auto things = at_time(traced_, doc, question, traceable);
  if (!things) return wrong(things.errors());
  Json hits = Json::array();
  for (const Json& ray : rays) {
    auto three = [&](std::size_t at) {
      return Vec3(coordinate(ray.at(at)), coordinate(ray.at(at + 1)), coordinate(ray.at(at + 2)));
    };
    hits.push_back(hit_json(**things, {three(0), glm::normalize(three(3))}, on));
  }
  return {200, {{"hits", std::move(hits)}}};
}

}  // namespace frond
