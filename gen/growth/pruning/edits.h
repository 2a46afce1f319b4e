#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/bark.h"
#include "pruning/address.h"

// Edits of branches by hand
// =========================
// A plant is cut, bent and strengthened at places that addresses name. All addresses refer to the plant
// before any edit, so that an edit means the same whatever others there are. A plant is edited as a model
// (edit_model) or as whatever else has nodes with parents (reshape), such as the history of a tree.

namespace frond {

/// What is done to one place: one of `cut`, `bend`, `strength`, `bare` and `bark` is given.
struct Edit {
  Address at;
  std::optional<std::size_t> plant = {};  ///< only of that planting of its entry, from 0; none: of all
  std::optional<double> cut = {};         ///< at the end of that year of its life; 0: whenever it is seen
  std::optional<Vec3> bend = {};          ///< metres in the plant's own frame, by which the place is pulled
  std::optional<double> strength = {};    ///< factor of length and thickness of all that is beyond the place
  bool bare = false;                      ///< what is beyond the place bears no leaves, flowers or fruit
  std::optional<BarkChange> bark = {};    ///< what is beyond the place wears in place of the plant's bark
  std::size_t number = 0;                 ///< its place in the list, for messages

  /// Whether it takes effect while the plant grows.
  bool dated() const { return cut.value_or(0) > 0; }
};

/// The edits of a list that concern one planting; of copies, which are no plantings, those that concern all.
std::vector<Edit> edits_of(std::span<const Edit> edits, std::optional<std::size_t> planting);

/// The end of what was cut off.
struct CutEnd {
  std::int32_t node = 0;  ///< whose segment was cut
  float within = 1;       ///< the share of that segment which is left
};

/// What edits make of the nodes of a plant.
struct Reshaped {
  std::vector<Vec3> position;  ///< of the whole segments, also of those that are cut
  std::vector<Quat> turn;      ///< of what is attached to each node, about it
  std::vector<float> factor;   ///< of length and thickness
  std::vector<std::uint8_t> gone;
  std::vector<CutEnd> ends;
  std::vector<float> levers;       ///< metres of limb that each edit bends; 0 where it bends none
  std::vector<std::string> notes;  ///< on what finds no branch: "/edits/2/at: finds no branch: ..."
  bool any = false;                ///< whether anything is changed

  /// Where a segment ends that is cut.
  Vec3 end(std::span<const std::int32_t> parent, CutEnd cut) const {
    return glm::mix(position[parent[cut.node]], position[cut.node], cut.within);
  }
};

/// Edits that are not dated, on nodes with these positions and radii. A cut at the foot of a branch leaves
/// its collar on what bore it. A bend keeps lengths. `levers`: of the same edits on the whole
/// plant, where this is a part of it that has grown so far: it is bent in proportion.
Reshaped reshape(const Branching& plant, std::span<const Vec3> position, std::span<const float> radius,
                 std::span<const Edit> edits, std::span<const float> levers = {});

/// Edits a model in its own frame; notes go to the model's. Where something is cut a wound shows, if the wood
/// is thick enough. The model tells afterwards which axes it had before. Gives the levers of the edits.
std::vector<float> edit_model(Model& model, std::span<const Edit> edits, std::span<const float> levers = {});

/// Takes the organs and blades off what edits leave bare; the faces of what was sawn off stay. Addresses that
/// find no branch are passed over. edit_model() does it, too.
void strip_model(Model& model, std::span<const Edit> edits);

/// Gives what wears another bark a colour index of its own: that of the first such edit is `colors`, how many
/// the plant's own bark has, then they go on. Addresses that find no branch are passed over. It is done
/// before edit_model(), which leaves colours as they are.
void color_barks(Model& model, std::span<const Edit> edits, std::size_t colors);

/// Adds the wound of a cut to the end of a branch that is thick enough; `open`: the share of it, 0..1, over
/// which no new bark has grown.
void add_cut_face(Model& model, std::int32_t node, Vec3 direction, std::uint32_t id, float open = 1);

}  // namespace frond
