#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/events.h"
#include "creeping/triangle_surface.h"
#include "land/scatter.h"
#include "world/obstacles.h"
#include "world/specimen.h"
#include "world/territory.h"

namespace frond {

/// The environment of organisms: the ground, everything that exists already, the times of the film. Kinds
/// grow in stages and see the results of earlier stages. Metres; thread-safe.
class World {
 public:
  World(Seed seed, Heights ground, double film_length, bool filmed, TakenSpots taken = {})
      : taken_(std::move(taken)),
        seed_(seed),
        ground_(std::make_shared<const Heights>(std::move(ground))),
        film_length_(film_length),
        filmed_(filmed) {}

  Seed seed() const { return seed_; }
  /// What happens once to its trees, and where storms blow, if the scene says so.
  const std::vector<Event>& events() const { return events_; }
  const std::optional<Vec3>& storms_toward() const { return storms_toward_; }
  void schedule(std::vector<Event> events, std::optional<Vec3> storms_toward) {
    events_ = std::move(events), storms_toward_ = storms_toward;
  }

  double film_length() const { return film_length_; }  ///< seconds
  bool filmed() const { return filmed_; }              ///< whether there is more than one frame

  /// Height of the ground at x, z.
  double height(Vec2 at) const { return (*ground_)(at.x, at.y); }
  const std::shared_ptr<const Heights>& ground() const { return ground_; }

  /// All existing specimens, in the order of the preset within each stage.
  std::span<const Specimen> standing() const { return standing_; }
  /// Adds the results of one more stage, which may change later answers. Not thread-safe.
  void add(std::vector<Specimen> grown);
  std::vector<Specimen> release() && { return std::move(standing_); }

  /// Objects on the ground that are no specimens: loose stones, rocks under corals.
  void lay(Surface stones) { stones_ = std::move(stones); }
  const Surface& stones() const { return stones_; }

  /// The outer surfaces of the bodies, each separately; without those of the setting.
  std::vector<Surface> bodies() const;

  /// The bodies of those names (empty: all) as one host for closest points and rays. Built once per list of
  /// names, and found once that there is none. An error that names `asker` if there is no body.
  Result<std::shared_ptr<const TriangleSurface>> host(const std::vector<std::string>& names,
                                                      std::string_view asker) const;

  /// The bodies, without those of the setting, as what limbs bend round. Made once.
  Result<std::shared_ptr<const Obstacles>> obstacles() const;

  /// The share of the sky that bodies leave open above a point, 0..1, each direction weighted by its height.
  double open_sky(const DVec3& at) const;

  /// Whether a spot within `radius` of a point is already taken.
  bool taken(Vec2 at, float radius) const { return !taken_.free(at, radius); }

  /// The territories of colonies; empty until they are settled.
  const Territories& territories() const { return territories_; }
  void settle(Territories territories) { territories_ = std::move(territories); }

 private:
  using HostOrNot = Result<std::shared_ptr<const TriangleSurface>>;
  HostOrNot build_host(const std::vector<std::string>& names) const;

  TakenSpots taken_;
  Seed seed_;
  std::shared_ptr<const Heights> ground_;
  std::vector<Event> events_;
  std::optional<Vec3> storms_toward_;
  double film_length_;
  bool filmed_;
  std::vector<Specimen> standing_;
  Territories territories_;
  Surface stones_;
  mutable std::mutex hosts_in_work_;
  mutable std::map<std::vector<std::string>, HostOrNot> hosts_;
  mutable std::optional<Result<std::shared_ptr<const Obstacles>>> obstacles_;
};

/// Food at a time, with the share that is not eaten yet, > 0.
struct FoodLeft {
  Vec3 at{0};
  float left = 1;
  bool operator==(const FoodLeft&) const = default;
};

/// Positions of food at a time in seconds, for all specimens that are drawn to food; each position once.
std::vector<FoodLeft> food_places(std::span<const Specimen> specimens, double time);

}  // namespace frond
