#pragma once

#include <string>
#include <string_view>
#include <type_traits>

#include "core/mask.h"
#include "core/text.h"
#include "core/vec.h"
#include "draw/sweep.h"
#include "model/surface.h"
#include "model/wetness.h"

namespace frond {

/// What we know of POV-Ray's axes, units and quirks. Our world is right-handed, POV-Ray's left-handed: z is
/// mirrored. A scene's unit is chosen so that its thinnest branch is not too thin for a sphere_sweep.
struct PovSpace {
  double unit = 10;  ///< POV-Ray units a metre
};

/// Objects that stand side by side, with the declarations that they need before them.
struct ObjectText {
  std::string text;
  std::size_t objects = 0;  ///< how many there are

  ObjectText& operator+=(const ObjectText& more) {
    text += more.text;
    objects += more.objects;
    return *this;
  }
};

inline constexpr double kThinnest = 0.002;  ///< POV-Ray units; sphere_sweeps break down below 0.0008

/// The space for a scene whose thinnest branch has the radius given in metres: 10 units a metre, or more in
/// powers of ten where that is too coarse (up to 1000).
PovSpace space_for(double thinnest_radius);

inline constexpr int kDecimals = 4;  ///< of places, in POV-Ray units

/// Decimals by which places are right to a twentieth of a pixel of so many metres; 0: all that are ever
/// written.
int decimals_for(const PovSpace& space, double pixel);

/// The textures of water and of snow, over that of an object; none where it is dry.
std::string weather_over(bool snowy, bool wet, Wetting wetting);

/// Appends `<x,y,...>`.
template <class... Numbers>
void append_vector(std::string& text, int decimals, Numbers... numbers) {
  text += '<';
  append_list(text, decimals, numbers...);
  text += '>';
}

/// `array[N]{...}` of items, each of which `append(text, item)` writes.
template <class Items, class Append>
std::string array_text(const Items& items, const Append& append) {
  std::string text = "array[" + std::to_string(items.size()) + "]{";
  for (const auto& item : items) {
    if (text.back() != '{') text += ',';
    append(text, item);
  }
  return text + '}';
}

/// Appends `<x,y,z>` of a place in the world.
void append_point(std::string& text, const PovSpace& space, Vec3 at, int decimals = kDecimals);

/// Appends `<x,y,z>` of a direction in the world.
void append_direction(std::string& text, Vec3 direction);

/// How many decimals of a matrix are written; more where it would have no inverse.
struct MatrixText {
  int decimals = 5, shift_decimals = kDecimals;
};
/// The decimals of a matrix that places a thing, up to `reach` metres from its origin, right to a tenth of a
/// pixel.
MatrixText matrix_text_for(const PovSpace& space, double reach, double pixel);

/// Appends a `matrix <...>` that does to POV-Ray's space what `matrix * x + shift` does to the world, and
/// returns true; appends nothing and returns false where it has no inverse as it would be written: POV-Ray
/// refuses such a one, and what it places has no size.
[[nodiscard]] bool append_matrix(std::string& text, const PovSpace& space, const glm::mat3& matrix,
                                 Vec3 shift, const MatrixText& how = {});

/// Appends a line that places what is declared by a name: `object{Name matrix<...>}`. Nothing where the
/// matrix has no inverse.
void append_object(std::string& text, const PovSpace& space, std::string_view name, const glm::mat3& matrix,
                   Vec3 shift, const MatrixText& how = {});

/// Appends `<r,g,b>` of linear light.
void append_light(std::string& text, Vec3 light);

/// Appends `srgb <r,g,b>`.
void append_color(std::string& text, const Color& color);

/// Appends `macro(a,b,...)`. Its arguments are colours, linear light, numbers and texts, which are taken as
/// they are.
template <class First, class... Rest>
void append_call(std::string& text, std::string_view macro, const First& first, const Rest&... rest) {
  auto add = [&]<class Argument>(char before, const Argument& argument) {
    text += before;
    if constexpr (std::is_same_v<Argument, Color>)
      append_color(text, argument);
    else if constexpr (std::is_same_v<Argument, Vec3>)
      append_light(text, argument);
    else if constexpr (std::is_arithmetic_v<Argument>)
      append(text, static_cast<double>(argument));
    else
      text += argument;
  };
  text += macro;
  add('(', first);
  (add(',', rest), ...);
  text += ')';
}

/// The same as a new text.
template <class... Arguments>
std::string call_text(std::string_view macro, const Arguments&... arguments) {
  std::string text;
  append_call(text, macro, arguments...);
  return text;
}

/// Declares a function of that name which is the mask at a place of POV-Ray's space, as Mask::at() is. The
/// mask has an area.
void declare_mask(std::string& text, const PovSpace& space, const Mask& mask, const std::string& name);

/// Appends a comment that cannot be ended by what is in it.
void append_comment(std::string& text, std::string_view words);

/// What a group of objects, one a line, begins with: a union, but not for a single one, of which POV-Ray
/// warns.
std::string_view group_opening(std::string_view lines);

/// How much of a surface is written: POV-Ray reads some 20 MB a second.
struct MeshText {
  int decimals = kDecimals;  ///< of places, in POV units
  int uv_decimals = 3;       ///< -1: no `uv`
  /// Normals are left out where they turn from their triangles by angles of no smaller cosine.
  float flat = 2;
};

/// Whether a mesh has triangles that are large enough to be drawn; POV-Ray refuses one without.
bool has_faces(const Surface& surface);

/// Appends a list of a mesh2: `name{count`, its items, `,` before each, and `}`.
template <class Items, class Append>
void append_items(std::string& text, std::string_view name, const Items& items, const Append& append_item) {
  text += name;
  text += '{';
  append_index(text, items.size());
  for (const auto& item : items) {
    text += ',';
    append_item(item);
  }
  text += "}\n";
}

/// Appends `mesh2 { ... }` without a texture, with the surface's `uv` where it has them. Triangles that are
/// points are left out.
void append_mesh(std::string& text, const PovSpace& space, const Surface& surface, const MeshText& how = {});

/// Appends the sphere_sweep of one chunk up to its texture, `sphere_sweep{linear_spline,n,<x,y,z>,r,...`, and
/// returns true; appends nothing and returns false where fewer than two different points are left of it.
/// Points are left out where that changes its outline by no more than `within` metres.
bool append_sweep(std::string& text, const PovSpace& space, const Skeleton& rest, const Pose& pose,
                  const Chunk& chunk, double within = 0, int decimals = kDecimals);

}  // namespace frond
