#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "core/vec.h"
#include "model/surface.h"

// Models of the program cpfg (vlab), derived as it derives them: the same words, with its order of rules, its
// 32-bit parameters, its variables and its random numbers.
//
//     Result<CpfgModel> model = read_cpfg("plant.l");
//     Result<CpfgDerived> derived = derive(*model, {});
//     std::string word = text(derived->word, *model);
//     Result<CpfgFigure> figure = draw(*model, derived->drawing);  // where CpfgRequest::drawing was set
//
// A model is a folder: the grammar `plant.l`, the view `plant.v` (turning angle, functions, curves), the
// animation `plant.a`, and files that these name. What cannot be had is refused with one message: models that
// need a program for their environment, models of lpfg (L+C) and of L-Py.

namespace frond {

namespace cpfg {
struct Code;
struct Shapes;
}  // namespace cpfg

/// The files of a model. Paths are empty where there is none.
struct CpfgFiles {
  std::filesystem::path grammar, view, animation;
  std::vector<std::filesystem::path> colours;  ///< `.map` and `.mat`, in the order of cpfg's command line
};

/// A line `key: value` of a view, after the preprocessor; of the animation likewise.
struct CpfgViewLine {
  std::string key, value;
  std::string where;  ///< file and line
};

/// A model as it was read.
struct CpfgModel {
  CpfgFiles files;
  std::vector<CpfgViewLine> view, animation;
  int steps = 0;                               ///< its derivation length
  std::vector<std::string> notes;              ///< what has no effect, as a rule that can never match
  std::shared_ptr<const cpfg::Code> code;      ///< the grammar, compiled
  std::shared_ptr<const cpfg::Shapes> shapes;  ///< surfaces, contours and colours
  std::vector<std::filesystem::path> read;     ///< all files that it was read from
  std::string content;                         ///< a hash of what they hold
};

/// One letter of a word with its parameters.
struct CpfgModule {
  char symbol = 0;
  std::uint8_t count = 0;      ///< of parameters
  std::uint32_t first = 0;     ///< its first parameter in CpfgWord::parameters
  std::int32_t instance = -1;  ///< of a `?(id,scale)` that begins a part under another L-system; -1 elsewhere
};

struct CpfgWord {
  std::vector<CpfgModule> modules;
  std::vector<float> parameters;
};

/// What the turtle of cpfg draws: the word after the homomorphism.
struct CpfgDrawing {
  CpfgWord word;
  std::vector<float> scale;  ///< of lengths and widths at each module, by the L-systems that it lies within
  std::vector<std::int32_t> origin;  ///< the module of the derived word that each came from
};

/// A straight piece of a line: a cone between two radii.
struct CpfgSegment {
  DVec3 from{0}, to{0};
  double radius_from = 0, radius_to = 0;
  int color = 0;             ///< index into CpfgFigure::colors, here and below
  std::int32_t before = -1;  ///< the segment that it goes on from; -1: none ends where it begins
  int depth = 0;             ///< of brackets
};

/// A filled polygon, which may be concave.
struct CpfgPolygon {
  std::vector<DVec3> points;
  int color = 0;
  std::int32_t segment = -1;  ///< that it is attached to, here and below; -1: none
};

/// The skin of a generalized cylinder whose contour is no circle. Those with circles are segments.
struct CpfgSkin {
  Surface mesh;  ///< with `uv` along and across it
  DVec3 foot{0};
  int color = 0;
  std::int32_t segment = -1;
};

/// A surface `~x` where the turtle stood.
struct CpfgPlaced {
  char surface = 0;  ///< a key of CpfgFigure::surfaces
  DVec3 position{0}, heading{0, 1, 0}, left{-1, 0, 0}, up{0, 0, -1};
  DVec3 factors{1};  ///< along left, heading and up
  int color = 0;
  std::int32_t segment = -1;

  /// Where a point of the surface is.
  DVec3 at(DVec3 p) const {
    p *= factors;
    return position + left * p.x + heading * p.y + up * p.z;
  }
};

/// A sphere, or a disc where there is a normal.
struct CpfgRound {
  DVec3 center{0}, normal{0};
  double radius = 0;
  int color = 0;
  std::int32_t segment = -1;
};

/// All that a model draws, in its own units, y up, the turtle beginning at the origin.
struct CpfgFigure {
  std::vector<CpfgSegment> segments;
  std::vector<CpfgPolygon> polygons;
  std::vector<CpfgSkin> skins;
  std::vector<CpfgPlaced> placed;
  std::vector<CpfgRound> spheres, discs;
  std::map<char, Surface> surfaces;  ///< x along the turtle's left, y along its heading, z along its up
  std::vector<Color> colors;         ///< of the model's map or materials
  DVec3 low{0}, high{0};             ///< the box round all of it
  DVec3 end{0}, end_heading{0, 1, 0}, end_left{-1, 0, 0}, end_up{0, 0, -1};  ///< the turtle, when it is done
  int max_stack_depth = 0;
};

/// Bounds that no model passes: it ends with a message instead.
struct CpfgLimits {
  int steps = 1'000'000;
  std::size_t modules = 40'000'000;  ///< of a word, parameters counted as modules; about 20 bytes each
  std::uint64_t work =
      2'000'000'000;                 ///< operations of formulas, modules looked at, in all; about 15 seconds
  std::uint64_t turns = 10'000'000;  ///< of one loop of a block, with those within it; about a second
};

struct CpfgRequest {
  std::optional<int> steps;     ///< nothing: the model's derivation length
  bool drawing = false;         ///< whether CpfgDerived::drawing is asked for
  std::uint64_t variation = 0;  ///< any other number: another plant of the model, whose chances are its own
  CpfgLimits limits;
};

struct CpfgDerived {
  CpfgWord word;
  CpfgDrawing drawing;
  int steps = 0;                   ///< how many were made: fewer than asked for where the model stops itself
  std::vector<std::string> notes;  ///< warnings of the derivation, each once: division by 0, a depth reached
};

/// Reads a model by the path of its `.l` file, with files beside it. Included ones lie below its folder.
Result<CpfgModel> read_cpfg(const std::filesystem::path& path);
/// Reads a model as the other read_cpfg() does, with `text` as what the `.l` file holds.
Result<CpfgModel> read_cpfg(const std::filesystem::path& path, std::string_view text);

/// Derives a word. The same model gives the same word always; an error says at which step which limit was
/// passed, or which line asks for what there is not.
Result<CpfgDerived> derive(const CpfgModel& model, const CpfgRequest& request);

/// Walks the turtle along a drawing. An error says which file of surfaces, contours or colours is missing, or
/// that the turtle leaves all bounds.
Result<CpfgFigure> draw(const CpfgModel& model, const CpfgDrawing& drawing);

/// A figure on the way from one to another, `share` of 0..1: segments and other parts that stand at the same
/// place in both move and grow, what is new unfolds, what is gone shrinks to where it stood.
CpfgFigure between(const CpfgFigure& a, const CpfgFigure& b, double share);

/// The steps that a model's animation shows: from one, by so many, to the last, which is at least `steps`.
struct CpfgFilm {
  int first = 0, step = 1, last = 0;
};
CpfgFilm film_of(const CpfgModel& model, int steps);

/// The colours of a model's map or materials; what each of its surfaces `~x` is like, in the turtle's axes;
/// and which of the files for these cannot be read.
const std::vector<Color>& colors_of(const CpfgModel& model);
std::map<char, Surface> surfaces_of(const CpfgModel& model);
std::optional<Error> missing_shapes(const CpfgModel& model);

/// A word as cpfg prints it, with numbers as short as tell 32-bit numbers apart.
std::string text(const CpfgWord& word, const CpfgModel& model);

}  // namespace frond
