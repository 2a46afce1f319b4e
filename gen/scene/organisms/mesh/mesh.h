#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "appearance/appearance.h"
#include "core/assets.h"
#include "core/result.h"
#include "geometry/polygon_mesh.h"
#include "model/model.h"

namespace frond {

/// What a file of a mesh holds, as a body: in triangles, y up, standing on the origin, its longest side one
/// unit long.
struct MeshBody {
  PartedSurface cut;
  double length = 1;                    ///< of its longest side, in units of the file
  std::vector<PolygonMesh::Part> part;  ///< by the numbers of `cut`
  std::vector<MeshMaterial> material;   ///< that they name
  std::vector<std::string> names;       ///< of all parts of the file: objects, groups, materials
  std::vector<std::string> notes;       ///< what the user should know of the file
  bool lies = false;                    ///< whether it looks as if z were up

  /// Whether a part bears one of the names.
  bool bears(std::uint32_t part, const std::vector<std::string>& wanted) const;
};

enum class UpAxis { y, z };
enum class LengthUnit { millimetres, centimetres, metres, inches, feet };

/// A body from a file.
struct MeshParams {
  FileName file;                         ///< relative to the preset's folder, or to the working folder
  UpAxis up = UpAxis::y;                 ///< axis of the file that points up
  std::vector<std::string> parts;        ///< names of those that are taken; none: all
  std::shared_ptr<const MeshBody> body;  ///< content of the file; null: it has not been read
  double size = 1;                       ///< metres, of its longest side, unless there is a unit
  std::optional<LengthUnit> unit;        ///< of the file, which keeps its size then
  std::vector<std::string> carries;      ///< names of parts that others may creep on; none: all
  Matter matter = Matter::limestone;
  Color color{0.74f, 0.71f, 0.64f};
  Color second{0.45f, 0.42f, 0.36f};
  double scale = 0.1;  ///< metres, of the pattern
  double weathering = 0.4;
  /// Whether the preset itself says so; else the file's materials count.
  bool own_matter = false, own_color = false, own_size = false;
};

/// Takes the content of a file, as `up` and `parts` say.
Errors load_mesh_body(const NamedFile& file, MeshParams& params);

/// Metres, of its longest side.
double size_of(const MeshParams& params);

/// Stands with the middle of its foot at the origin. Where the file has materials with colours, each is a
/// solid of its own. Where it carries creepers on some parts only, the others of its hull are barred to them.
Result<Model> build_mesh_model(const MeshParams& params);

/// The pictures that its materials wear.
std::vector<Drawing> mesh_pictures(const MeshParams& params);

/// What of the file is not drawn, or may not be meant so. Pointers below the organism.
Errors mesh_warnings(const MeshParams& params);

}  // namespace frond
