#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/result.h"
#include "draw/branches.h"
#include "emit/pov.h"

// The textures of branches: which macro of povinc is called with what.

namespace frond {

/// Declares the skins of a look from `first` on, one for each colour, other barks included; `starving`: also
/// what becomes of one in the shade. The arrays Skin and Skin_Pigment must have room for them.
void append_skin_declarations(std::string& text, const BranchLook& look, double brightness, std::size_t first,
                              bool starving, std::string_view name);

/// `texture{Skin[7]}`: the skin of that number, as it was declared.
std::string skin_texture(std::size_t index);

/// Appends `texture{...}` of a chunk: the skin of number `index`, younger toward a tip, carried to where the
/// skin has moved.
void append_chunk_texture(std::string& text, const PovSpace& space, const DrawnBranches& branches,
                          Chunk chunk, std::size_t index);

/// Textures that chunks share of which nothing shows but their colour, each of one age: numbers below
/// count().
struct SharedTextures {
  static constexpr std::size_t kAges = 33;
  const DrawnBranches& branches;
  float dot = 0;  ///< metres: along a chunk that is no longer no change of age shows

  std::size_t count() const { return branches.look().colors() * kAges; }
  /// None where the chunk needs its own.
  std::optional<std::size_t> of(const Chunk& chunk) const;
  /// `texture{...}` of one; `index` is the number of the first skin.
  std::string text(std::size_t number, std::size_t index) const;
};

/// The branches of a tree that wears a bark as a picture: one mesh with its texture for each picture; empty
/// while none of it has grown. Where the eye is near, furrows are let in.
ObjectText coat_text(const PovSpace& space, const DrawnBranches& branches, Vec3 eye, double pixel);

/// The branches of one organism as one body, fused, rough or of cubes as its style says. A fused or rough one
/// bears the textures of the chunks, each vertex that of the chunk it is nearest to, so that they stick to
/// the skin as they do to sweeps. An error where the volume passes the limit of its style.
Result<ObjectText> body_text(const PovSpace& space, const DrawnBranches& branches, std::size_t skin);

inline constexpr int kCubeAges = 4, kCubeShades = 4;
/// `texture{Voxel_Skin(...)}` of cubes of one colour, age and shade, and a side in metres.
std::string cube_texture(const BranchLook& look, std::size_t color, double brightness, double side, int age,
                         int shade);

/// The name of a picture that is declared once a frame, as POV-Ray reads a file anew wherever it is named.
std::string picture_id(std::string_view as, std::string_view file);
/// Declares something unless another has already.
void declare_once(std::string& text, std::string_view id, std::string_view what);

/// Declares pictures of leaves, "Picture" of each, and where what comes through has another colour its
/// "Half".
void declare_pictures(std::string& text, const std::vector<std::string>& files, bool lit);
/// An array of declared pictures; one of colours.
std::string array_of(std::string_view as, const std::vector<std::string>& files);
std::string array_of(const std::vector<Color>& colors);
/// Whether light that comes through leaves has another colour.
bool is_lit(const std::optional<Luster>& luster);

/// Declares the pictures that copy_texture() names.
void declare_coat(std::string& text, const BranchLook& look, std::size_t color);
/// What stands in the texture of a copy's branches of one colour, for a tint T.
std::string copy_texture(const BranchLook& look, std::size_t color);
/// Whether that needs places on the mesh.
bool is_pictured(const BranchLook& look, std::size_t color);

/// The povinc file that branches need, as `coral`; empty: none. For copies, besides that of all copies.
std::string_view include_of(const BranchLook& look);
std::string_view copy_include(const BranchLook& look);

}  // namespace frond
