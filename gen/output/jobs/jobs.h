#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

/// The text of the job files of a film: what `ninja` is to build, and what the film is made of. Text only;
/// gen/output/render runs the processes.
///
///     DIR/frames/frame_0001.pov -> DIR/frames/frame_0001.png     frond frame
///     or, where frames are resolved,
///     DIR/frames/frame_0001.pov -> DIR/raw/frame_0001.png        frond frame
///     those of some frames      -> DIR/frames/frame_0001.png     frond resolve
///     all frames                -> DIR/film.mp4, .webm, .gif     frond film
///     or, with opacity,         -> DIR/film.mov, .webm, .gif     frond film
///     some frames               -> DIR/contact.png               frond film
///     the frame of a still      -> DIR/still.png                 frond film
///
///     write_file(dir / "build.ninja", ninja_text(jobs));
///     write_file(dir / "manifest.json", manifest_text(manifest));
namespace frond {

/// POV-Ray settings of a quality. Jitter is always off, so that equal scenes give equal pixels at any number
/// of threads, and an interrupted picture can be continued.
struct Rendering {
  std::string_view quality;
  std::string_view flags;
  std::string_view through_lens;  ///< the flags if the camera has a lens, where each sample is many rays
};

inline constexpr Rendering kRenderings[] = {
    {"draft", "+A0.15 +AM1 +R2 -J", "+A0.15 +AM1 +R2 -J"},
    {"good", "+A0.0 +AM1 +R3 -J", "+A0.0 +AM1 +R2 -J"},
    {"best", "+A0.0 +AM1 +R5 -J", "+A0.0 +AM1 +R3 -J"},
};

/// Those of a frame that others are resolved from: one sample a pixel.
inline constexpr std::string_view kRawFlags = "-A -J";

/// POV-Ray's flags for a quality; empty for an unknown name.
std::string_view povray_flags(std::string_view quality, bool lens);

/// What a film may be; one of frames without opacity is the first of these unless it is asked for otherwise,
/// one with opacity the second.
inline constexpr std::string_view kFilmFormats[] = {"mp4", "mov", "webm", "gif", "webp"};
inline constexpr std::string_view film_format(bool transparent) { return kFilmFormats[transparent ? 1 : 0]; }

/// The name of a film in the folder of its frames.
std::string film_file(std::string_view format);

/// All that may be made of finished frames: films of each format, the sheet, the still.
std::vector<std::string> result_files();

/// What to render. A change of size or quality renders all frames again, as both are in the commands; a frame
/// is also rendered again if its scene or one of the includes is newer than its picture.
struct JobList {
  std::vector<int> frames;             ///< frame numbers, ascending, at least one
  std::array<int, 2> size{480, 270};   ///< width and height, pixels
  std::string_view quality = "draft";  ///< a name of kRenderings
  bool lens = false;                   ///< whether the camera has a lens, see Rendering
  int exposures = 1;                   ///< number of scenes that make a frame
  std::vector<int> raws;               ///< of a film that is resolved: those that are rendered, ascending
  int window = 0;                      ///< how many of them before and after a frame it is resolved from
  std::vector<std::string> resolve;    ///< the words that say to `frond resolve` which preset it is
  double fps = 24;                     ///< frames a second, above 0
  bool still = false;                  ///< one picture, no film
  bool transparent = false;            ///< whether its pictures have opacity, which a film keeps
  double dpi = 0;                      ///< pixels an inch, which a still says; 0: it says none
  bool rendered = false;               ///< the pictures already exist: only the film is to be made
  std::string title;                   ///< goes into the film's metadata
  std::uint64_t seed = 0;              ///< the same
  std::string povinc = "../povinc";    ///< folder of the includes, as seen from DIR; no line break in it
  std::vector<std::string> includes;   ///< names of the files there that a frame may read: "frond_water.inc"
  std::string program = "../build/frond";  ///< this program, as seen from DIR; no line break in it
};

/// build.ninja. Its default targets are film.mp4 (with opacity film.mov) and contact.png, or still.png. Paths
/// and title may contain any character but a line break (one in a title becomes a blank).
std::string ninja_text(const JobList& jobs);

/// The value of a variable at the top of a build.ninja; empty if there is none of that name.
std::string ninja_variable(std::string_view ninja, std::string_view name);

/// A record of what the film is made of. It contains no clock time and no absolute path: the same film has
/// the same manifest everywhere.
struct Manifest {
  struct Frame {
    int number = 1;
    double time = 0;        ///< seconds from the first frame of the preset
    std::size_t nodes = 0;  ///< number of skeleton nodes reached by growth
  };
  /// A budget of growth in seconds, as it was counted when the film was first generated.
  struct Budget {
    std::string pointer;  ///< JSON pointer of the budget in the preset
    double seconds = 0;   ///< that the preset allows
    int internodes = 0;   ///< that they allowed on the machine where it was counted
  };
  std::string version;  ///< of frond
  std::string preset;   ///< the preset's file name without .json
  std::string title;
  std::string preset_hash;  ///< of the preset with all command line settings, hexadecimal
  std::uint64_t seed = 0;
  double fps = 24;
  std::array<int, 2> size{480, 270};
  std::string_view quality = "draft";
  bool still = false;
  bool transparent = false;      ///< whether its pictures have opacity
  double render_seconds = 0;     ///< per frame, estimated for a processor as ours
  std::array<int, 2> raw{0, 0};  ///< first and last of the raw frames of which they are resolved; 0: none
  std::vector<Budget> budgets;
  std::vector<Frame> frames;

  /// Where what POV-Ray draws is kept, and the first and last of it.
  std::string_view drawn_folder() const { return raw[0] > 0 ? "raw" : "frames"; }
  std::array<int, 2> drawn() const {
    return raw[0] > 0 ? raw : std::array{frames.front().number, frames.back().number};
  }
};

/// manifest.json, one frame per line.
std::string manifest_text(const Manifest& manifest);

/// Reads it again, without seed and quality.
Result<Manifest> read_manifest(std::string_view text, const std::string& file_name);
/// That of the film in a folder.
Result<Manifest> manifest_in(const std::filesystem::path& folder);

}  // namespace frond
