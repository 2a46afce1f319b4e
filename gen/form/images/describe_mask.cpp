#include "images/describe_mask.h"

#include "core/assets.h"

namespace frond {

namespace {

constexpr Choice<Axis> kAxes[] = {{"x", Axis::x, "seen from the side: z to the right, y up"},
                                  {"y", Axis::y, "seen from above: x to the right, z down"},
                                  {"z", Axis::z, "seen from the front: x to the right, y up"}};

}  // namespace

void describe_projection(Properties& v, Mask& m) {
  v.choice("along", m.along, kAxes,
           "Axis of the world along which the picture is projected, onto all sides alike");
  v.list("area", m.area, Count{2, 2},
         "Two opposite corners of what the picture covers, in metres of the world: [x, z] along y, [x, y] "
         "along z, [z, y] along x; beyond them its edges go on");
}

void describe(Properties& v, Mask& m) {
  v.shorthand("file");
  v.file(
      "file", m.file, [&](const NamedFile& file) { return load_mask(file, m); },
      "A picture (PNG, JPEG or WebP), named as seen from the preset's folder, whose brightness scales what "
      "the map is for: none where it is black, all where it is white");
  describe_projection(v, m);
}

}  // namespace frond
