#pragma once

#include <functional>
#include <vector>

#include "core/seed.h"
#include "core/vec.h"
#include "model/solid.h"
#include "model/surface.h"

namespace frond {

/// A stream in hilly land.
struct StreamShape {
  Vec2 from{0};        ///< x, z in metres, where it comes out of the ground
  double width = 0;    ///< metres, of its water, on average; 0: no stream
  double depth = 0.3;  ///< metres, in the middle
  int leaves = 60;     ///< that drift on it
};

/// A place on its middle line.
struct StreamPoint {
  Vec2 at{0};         ///< x, z in metres
  Vec2 toward{1, 0};  ///< in which it flows, of length 1
  float along = 0;    ///< metres from where it begins
  float level = 0;    ///< metres, height of its water
  float half = 0.5f;  ///< metres from the middle to the shore
};

/// A leaf on the water, or anything else that lies there.
struct Afloat {
  Vec3 at{0};      ///< metres
  float turn = 0;  ///< radians about the vertical
  float size = 1;  ///< factor: leaves come up at its beginning and go down at its end
  int kind = 0;    ///< which of the leaves it is, from 0 on
};

/// The course of a stream and the bed that it has cut. It runs down the land to the rim of its square, out of
/// hollows over their lowest saddle (priority flood, Barnes, Lehman and Mulla 2014), and winds with a
/// wavelength of eleven times its width (Leopold and Wolman 1960).
class StreamCourse {
 public:
  StreamCourse() = default;
  /// `land` gives heights before there was a stream, on a square of `side` metres about the origin.
  StreamCourse(const StreamShape& shape, double side, const std::function<double(Vec2)>& land, Seed seed);

  bool flows() const { return !course_.empty(); }
  const std::vector<StreamPoint>& course() const { return course_; }
  /// Metres to the shore of the stream, negative on the water.
  double distance(Vec2 at) const;
  /// The height of land that was at height `land`: the bed of the stream, and banks that rise from it.
  double height(Vec2 at, double land) const;
  /// The height of ground that is seen beside the bed alone and was at height `land`: that of height(), but
  /// lower below the bed.
  double ground(Vec2 at, double land) const;
  /// Moves the whole course up by so many metres.
  void raise(float by);

  /// The mean speed of the water, metres a second, after Manning (1891) with a roughness of 0.06, a bed of
  /// cobbles (Chow 1959).
  double speed() const { return speed_; }

  /// The water: level across, `uv` metres along and across. The bed: `uv` is how deep each place lies below
  /// the water, metres, and 0.
  Surface water() const;
  Surface bed() const;
  /// Stones in the bed of the stream and on its banks.
  Solids stones() const;
  /// Leaves that drift on the water at a time, seconds; in a film that loops after `loop` seconds the same
  /// after that. 0: it does not loop.
  std::vector<Afloat> leaves(double time, double loop) const;

 private:
  struct Near {
    double away = 1e9;  // metres from the middle
    StreamPoint at{};
    double shore() const { return away - at.half; }
  };
  Near near(Vec2 at) const;
  double height(const Near& near, double land) const;
  double bed_height(const Near& near) const;
  Surface strip(double beyond, int columns,
                const std::function<Vec3(const StreamPoint&, float)>& place) const;

  StreamShape shape_;
  std::vector<StreamPoint> course_;
  double speed_ = 0;
  Seed seed_;
};

}  // namespace frond
