#include "scene/entry_seeds.h"

#include <map>
#include <string>

#include "preset/json.h"

namespace frond {

namespace {

/// The kind that an entry was read as.
std::string kind_of(const Preset& preset, std::size_t entry) {
  const Value* entries = preset.written ? preset.written->find("organisms") : nullptr;
  const Value* kind = entries && entry < entries->items.size() ? entries->items[entry].find("kind") : nullptr;
  return kind ? kind->text : "";
}

}  // namespace

std::vector<Seed> entry_seeds(const Preset& preset, std::string_view purpose) {
  Seed seed{preset.seed};
  std::vector<Seed> seeds;
  std::map<std::string, std::uint64_t> met;
  for (std::size_t o = 0; o < preset.organisms.size(); ++o) {
    const std::string& name = preset.organisms[o].name;
    std::string like = name.empty() ? "kind " + kind_of(preset, o) : "name " + name;
    std::uint64_t before = met[like]++;
    seeds.push_back(preset.version < 2 ? seed.child(purpose, o) : seed.child(purpose).child(like, before));
  }
  return seeds;
}

Seed planting_seed(const Preset& preset, Seed entry, std::string_view found_by, std::uint64_t number,
                   std::uint64_t attempt) {
  return preset.version < 2 ? entry.child("instance", number) : entry.child(found_by, attempt);
}

}  // namespace frond
