#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "creeping/host.h"
#include "land/scatter.h"
#include "world/specimen.h"
#include "world/territory.h"

namespace frond {

/// What organisms grow in: the ground, all that stands already, the film's times. Kinds grow in stages, so
/// what stands is what earlier stages have made. Metres; may be asked from many threads.
class World {
 public:
  World(Seed seed, Heights ground, double film_length, bool filmed, TakenSpots taken = {})
      : taken_(std::move(taken)),
        seed_(seed),
        ground_(std::make_shared<const Heights>(std::move(ground))),
        film_length_(film_length),
        filmed_(filmed) {}

  Seed seed() const { return seed_; }
  double film_length() const { return film_length_; }  ///< seconds
  bool filmed() const { return filmed_; }              ///< whether there is more than one frame

  /// How high the ground lies at x, z.
  double height(Vec2 at) const { return (*ground_)(at.x, at.y); }
  const std::shared_ptr<const Heights>& ground() const { return ground_; }

  /// All that stands, in the order of the preset within each stage.
  std::span<const Specimen> standing() const { return standing_; }
  /// One more stage has grown; what was asked before may have another answer now. Not while others ask.
  void add(std::vector<Specimen> grown);
  std::vector<Specimen> take_all() && { return std::move(standing_); }

  /// What lies on the ground and is no specimen: loose stones, rocks under corals.
  void lay(Surface stones) { stones_ = std::move(stones); }
  const Surface& stones() const { return stones_; }

  /// The outsides of the bodies, each by itself; without what belongs to the setting.
  std::vector<Surface> bodies() const;

  /// The bodies of those names, of all where there are none, as one host: it answers for closest points and
  /// rays. Made once for each list of names. An error, which says `asker`, where no body is left.
  Result<std::shared_ptr<const Host>> host(const std::vector<std::string>& names,
                                           std::string_view asker) const;

  /// The share of the sky that bodies leave open above a place, 0..1, each direction weighted by its height.
  double open_sky(const DVec3& at) const;

  /// Whether something has taken the room within `radius` of a place already.
  bool taken(Vec2 at, float radius) const { return !taken_.free(at, radius); }

  /// The space that colonies fight for; empty until they are settled.
  const Territories& territories() const { return territories_; }
  void settle(Territories territories) { territories_ = std::move(territories); }

 private:
  TakenSpots taken_;
  Seed seed_;
  std::shared_ptr<const Heights> ground_;
  double film_length_;
  bool filmed_;
  std::vector<Specimen> standing_;
  Territories territories_;
  Surface stones_;
  mutable std::mutex hosts_in_work_;
  mutable std::map<std::vector<std::string>, std::shared_ptr<const Host>> hosts_;
};

/// Food at a time, and the share of it that is not eaten yet, > 0.
struct FoodLeft {
  Vec3 at{0};
  float left = 1;
  bool operator==(const FoodLeft&) const = default;
};

/// Where food is at a time in seconds, for all that is drawn to some; each place once.
std::vector<FoodLeft> food_places(std::span<const Specimen> specimens, double time);

}  // namespace frond
