#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/lru_cache.h"
#include "core/result.h"
#include "draw/draw_list.h"
#include "scene/scene.h"
#include "studio/packet.h"

namespace frond {

/// What was made ready to be sent and may be wanted again. May be asked from many threads.
class ViewCache {
 public:
  explicit ViewCache(const std::shared_ptr<CacheBudget>& budget) : parts(budget), models_(budget) {}

  /// Model `which` of what is sown, at some levels of detail. Its head has "levels".
  Result<std::shared_ptr<const DrawnPart>> model(const CopySet& set, int which);

  /// The parts of specimens, by what those grew from and the time.
  LruCache<std::vector<DrawnPart>> parts;

 private:
  LruCache<DrawnPart> models_;
};

/// What of a scene is wanted.
struct ViewRequest {
  double time = 0;                            ///< seconds
  std::set<std::string> kept;                 ///< ids of parts that need not be sent again
  std::optional<std::set<std::size_t>> solo;  ///< only these of the preset's organisms
  std::set<std::size_t> hidden;
  bool shows(std::size_t entry) const { return !hidden.contains(entry) && (!solo || solo->contains(entry)); }
};

/// Everything that stands in a scene at one time, as a packet that the page draws (docs/studio.md describes
/// its bytes). `header` brings what the caller has to add.
Result<std::string> view_of(const Scene& scene, const Preset& preset, const ViewRequest& request,
                            ViewCache& models, Json header);

/// The parts of one organism at a time.
Result<std::vector<DrawnPart>> specimen_parts(const Specimen& specimen, double time);

/// Branches as segments of 48 bytes each: both ends with radii, directions and colours, and how a picture
/// lies on them.
/// Those of the plant's own bark, then those of each other bark that is worn.
std::vector<DrawnPart> tubes_parts(const DrawnBranches& branches);

/// Appends a place of a mesh, ten numbers, and a colour, four bytes.
void push(std::vector<float>& places, Vec3 at, Quat turn, Vec3 scale);
void push(std::vector<std::uint8_t>& colors, const Color& color);

/// A mesh that is placed at `places`, ten numbers each, with coarser ones for where it is small: those of
/// leaves keep what each piece covers. "coarse" lists them with the "size" in metres of what they lose.
void add_placed(DrawnPart& part, const Surface& surface, std::span<const float> places, bool leaf);

/// `{"color", "gloss", "both_sides", …}`.
Json material_json(const PlainLook& look);

}  // namespace frond
