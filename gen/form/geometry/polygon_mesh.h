#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/vec.h"
#include "model/surface.h"

namespace frond {

/// What a file says of how a part of a mesh looks.
struct MeshMaterial {
  std::string name;
  std::optional<Color> color;                  ///< none: the file does not say
  double opacity = 1;                          ///< 0 invisible .. 1
  std::string picture_name;                    ///< as the file names it; empty: none
  std::shared_ptr<const std::string> picture;  ///< bytes of that picture; null: none, or it cannot be had
};

/// A mesh as files hold it: polygons over places in double precision, in the unit of the file, which corners
/// name by index. Plain data.
struct PolygonMesh {
  static constexpr std::int32_t kNone = -1;
  struct Corner {
    std::uint32_t place = 0;
    std::int32_t texture = kNone, normal = kNone;
  };
  struct Face {
    std::size_t first = 0;    ///< of its corners
    std::uint32_t count = 0;  ///< of them, >= 3
    std::uint32_t part = 0;
    int line = 0;  ///< of a text, for messages; 0: none
  };
  /// What faces have in common. Names are empty where the file gives none.
  struct Part {
    std::string object, group;
    std::int32_t material = kNone;
    bool operator==(const Part&) const = default;
  };

  std::vector<DVec3> place;
  std::vector<Vec3> color;    ///< of each place, 0..1; empty: none
  std::vector<Vec2> texture;  ///< v upward
  std::vector<Vec3> normal;   ///< of any length
  std::vector<Corner> corner;
  std::vector<Face> face;
  std::vector<Part> part{{}};
  std::vector<MeshMaterial> material;
  std::vector<std::string> library;  ///< files of materials that it names
  std::vector<std::string> notes;    ///< what of the file is not as its maker may think

  /// Index of a part, which is added where it is new.
  std::uint32_t part_of(const Part& wanted);
  /// Whether a part bears that name: that of its object, group or material.
  bool bears(std::uint32_t part, const std::string& name) const;
  /// All such names, each once, in the order of the file.
  std::vector<std::string> names() const;
};

/// What of a mesh is taken, and how it lies in the world.
struct MeshFrame {
  DVec3 origin{0};               ///< of the file's places: it comes to lie at 0
  double scale = 1;              ///< metres for one of the file's units
  bool z_up = false;             ///< z of the file is up, and -y comes to the front
  std::vector<char> taken = {};  ///< of each part, whether it is; empty: all are
};

/// As triangles, with the part of each.
struct PartedSurface {
  Surface surface;
  std::vector<std::uint32_t> part;
  bool normals_kept = true;  ///< false where those of the file did not fit its faces
};

/// Cuts its polygons into triangles, which are brought into a frame in double precision and only then
/// narrowed. Faces without area are dropped. Closed pieces are turned outward, but for hollows in others. The
/// normals of the file are kept where all corners have one and they agree with their faces; else they are
/// smooth except across edges of more than 40 degrees. Texture coordinates and colours (as grey) become
/// paint. An error, which names `name`, where nothing is left, or a face cannot be cut.
Result<PartedSurface> parted_surface(const PolygonMesh& mesh, const MeshFrame& frame,
                                     const std::string& name);

/// The box of the places that taken faces name, in the file's own axes and unit; empty where there is none.
struct MeshBox {
  DVec3 low{0}, high{0};
  bool empty = true;
};
MeshBox box_of(const PolygonMesh& mesh, const std::vector<char>& taken);

}  // namespace frond
