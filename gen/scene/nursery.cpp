#include "scene/nursery.h"

#include <algorithm>

namespace frond {

namespace {

std::size_t bytes_of(const Surface& s) {
  return s.position.size() * 2 * sizeof(Vec3) + s.triangle.size() * sizeof s.triangle[0] +
         s.uv.size() * sizeof(Vec2);
}

/// About, without what is shared.
std::size_t bytes_of(const Model& m) {
  constexpr std::size_t kNode = 34, kOrgan = 72, kPlacement = 44;
  std::size_t bytes = m.skeleton.size() * kNode + m.organs.size() * kOrgan + m.solids.size() * kPlacement;
  bytes += bytes_of(m.blades.surface) + bytes_of(m.hull);
  for (const Prototype& prototype : m.prototypes)
    for (const OrganPart& part : prototype.parts) bytes += bytes_of(part.surface);
  for (const Solid& solid : m.solids.shapes) bytes += bytes_of(solid.surface);
  return bytes;
}

}  // namespace

std::optional<std::vector<Specimen>> Nursery::find(const std::string& key) {
  std::lock_guard lock(in_work_);
  auto found = kept_.find(key);
  if (found == kept_.end()) return std::nullopt;
  found->second.used = ++now_;
  return found->second.specimens;
}

void Nursery::keep(const std::string& key, std::vector<Specimen> grown) {
  std::size_t bytes = 0;
  for (const Specimen& s : grown) bytes += bytes_of(s.model);
  std::lock_guard lock(in_work_);
  auto [at, fresh] = kept_.try_emplace(key);
  if (!fresh) return;  // another scene has brought the same
  at->second = {std::move(grown), bytes, ++now_};
  bytes_ += bytes;
  while (bytes_ > most_ && kept_.size() > 1) {
    auto oldest = std::ranges::min_element(kept_, {}, [](const auto& entry) { return entry.second.used; });
    bytes_ -= oldest->second.bytes;
    kept_.erase(oldest);
  }
}

}  // namespace frond
