#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Frond as a library
// ==================
// Presets are read and changed, grown, looked at, exported, and rendered as films:
//
//     #include <frond/frond.h>
//
//     frond::api::Preset preset = frond::api::Preset::read("oak");
//     preset.set("/organisms/0/years", "80");
//     frond::api::Scene scene = frond::api::grow(preset);
//     scene.export_to("oak.glb");
//     for (auto& file : frond::api::render(preset, "out/oak")) std::cout << file << '\n';
//
// In CMake: find_package(Frond) and target_link_libraries(mine PRIVATE Frond::frond).
//
// Lengths are metres, y is up, times are seconds from a film's first frame, frames count from 1. The same
// preset gives the same scene at any number of threads. Functions may be called from several threads, but of
// one Preset or Scene one that is not const only while no other is. Files appear whole or not at all.

namespace frond::api {

/// Something found: where (`file:line:column: /json/pointer`, or empty) and what, with what was expected.
struct Message {
  std::string where, what;
};

/// Thrown where something cannot be done, with all that is wrong, at least one; what() is that as lines.
class Failure : public std::runtime_error {
 public:
  /// `of_input`: what was given is wrong; else it is the machine, the disk or another program.
  Failure(std::vector<Message> messages, bool of_input);

  const std::vector<Message>& messages() const { return messages_; }
  bool of_input() const { return of_input_; }

 private:
  std::vector<Message> messages_;
  bool of_input_;
};

/// Thrown where a Listener has cancelled what was at work.
class Cancelled : public std::exception {
 public:
  const char* what() const noexcept override { return "cancelled"; }
};

/// Hears how far the work is, and may cancel it. step() and cancelled() are called from several threads, all
/// others from the one that called.
class Listener {
 public:
  virtual ~Listener() = default;

  /// A phase of so many steps begins: "grow", "frames".
  virtual void begin(std::string_view /*phase*/, std::size_t /*steps*/) {}
  virtual void step() {}
  /// A line for people.
  virtual void note(std::string_view /*line*/) {}
  /// So many of all frames are rendered; `words` say that with the time that is left.
  virtual void rendered(int /*done*/, int /*all*/, std::string_view /*words*/) {}
  /// Whether the work is to end, soon and with Cancelled. Asked often.
  virtual bool cancelled() { return false; }
};

/// The folder of presets, macros and templates, where neither $FROND_HOME is set nor Frond is installed.
/// Before anything else is called.
void set_home(const std::filesystem::path& folder);

/// The JSON Schema (draft-07) of presets.
std::string schema();

/// A preset, which says what is grown and filmed (docs/presets.md): read, and without a fault.
class Preset {
 public:
  /// Reads a file, or a preset that comes with Frond, by its name: "oak", "garden/vases". With `assets` no
  /// file that it names is read but below the preset's own folder and that one.
  static Preset read(const std::filesystem::path& file,
                     const std::optional<std::filesystem::path>& assets = {});
  /// Reads a preset from a text; `file` is for messages, and files that the text names are looked for from
  /// there.
  static Preset parse(std::string text, const std::filesystem::path& file = "preset.json",
                      const std::optional<std::filesystem::path>& assets = {});
  Preset(const Preset&);
  Preset(Preset&&) noexcept;
  Preset& operator=(Preset);
  ~Preset();

  /// Sets the value at a JSON pointer, which may be new: set("/film/size", "[640, 360]"). What would be wrong
  /// throws and leaves the preset as it was.
  void set(const std::string& pointer, const std::string& json);

  /// The whole preset as JSON, with what was set.
  std::string text() const;
  const std::filesystem::path& file() const;
  std::string title() const;
  std::uint64_t seed() const;
  int frames() const;
  double frames_a_second() const;
  std::array<int, 2> size() const;  ///< pixels, width and height
  /// Notes on what is no fault but probably not intended.
  std::vector<Message> notes() const;

  struct Data;
  const Data& data() const { return *data_; }

 private:
  explicit Preset(std::unique_ptr<Data> data);
  std::unique_ptr<Data> data_;
};

/// An individual as it has grown.
struct Organism {
  std::string name;
  std::size_t nodes = 0;         ///< of its skeleton
  std::array<double, 3> foot{};  ///< metres
};

/// How a scene becomes meshes.
struct ExportOptions {
  std::optional<int> frame = {};  ///< none: the last
  double detail = 2.5e5;          ///< triangles of one organism, about: 100 to 1e9
  int sides = 10;                 ///< of the tubes that branches become: 3 to 256
  int texture = 512;              ///< pixels, the width of pictures of bark and leaves; 0: none; 4096 at most
  int levels = 1;                 ///< of detail, of a .glb: 1 to 6
  double voxel = 0;               ///< metres, of a .vdb; 0: as the organisms have it
  bool instances = false;         ///< organs and bodies once each, with their placements
};

/// Everything that stands before the camera, grown.
class Scene {
 public:
  std::vector<Organism> organisms() const;
  std::size_t nodes() const;
  std::vector<std::string> notes() const;

  /// A picture without a renderer, as PNG bytes; none: the last frame.
  std::string look(std::optional<int> frame = {}) const;
  /// Depth, normals, motion and masks of a frame, as the bytes of an OpenEXR picture (docs/data.md).
  /// `side` * `side` rays a pixel tell its shares.
  std::string passes(std::optional<int> frame = {}, int side = 4) const;
  /// Writes .obj, .ply, .glb or .vdb, by the name of the file.
  void export_to(const std::filesystem::path& file, const ExportOptions& options = {}) const;

  struct Data;

 private:
  friend Scene grow(const Preset& preset, Listener* listener);
  explicit Scene(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  std::shared_ptr<const Data> data_;
};

Scene grow(const Preset& preset, Listener* listener = nullptr);

struct RenderOptions {
  std::optional<std::array<int, 2>> frames = {};  ///< first and last; none: all
  std::string format = {};  ///< mp4, webm, gif, webp or mov; empty: mp4, or mov with opacity
  int jobs = 0;             ///< processors; 0: all
  int every = 1;            ///< each K-th frame first, then those between
  bool watch = false;       ///< keeps watch.png, which shows what is being traced
  /// Whether frames are resolved from raw ones of one sample a pixel; none: in the quality good.
  std::optional<bool> resolve = {};
  /// The program `frond`, which what is rendered calls; empty: $FROND_BIN, the one that came with the
  /// library, or that of PATH.
  std::filesystem::path program = {};
};

/// Writes frames as POV-Ray scenes, with what they include, into a folder; of `options`, frames and resolve
/// count. Renders nothing.
void write_frames(const Preset& preset, const std::filesystem::path& folder,
                  const RenderOptions& options = {}, Listener* listener = nullptr);

/// Has POV-Ray render a film or a still into a folder, and ffmpeg encode it; the files made. What is finished
/// in the folder stays, and the same call goes on from it, as does `frond render`.
std::vector<std::filesystem::path> render(const Preset& preset, const std::filesystem::path& folder,
                                          const RenderOptions& options = {}, Listener* listener = nullptr);

/// An L-system of a file: Frond's own, or of LParser, Fractint or Houdini.
class Grammar {
 public:
  static Grammar read(const std::filesystem::path& file);

  /// The word after so many steps; none: as many as the file says.
  std::string derive(std::optional<int> steps = {}, std::optional<std::uint64_t> seed = {}) const;
  /// What the turtle draws, as SVG.
  std::string svg(std::optional<double> steps = {}, std::optional<std::uint64_t> seed = {}) const;

  struct Data;

 private:
  explicit Grammar(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  std::shared_ptr<const Data> data_;
};

}  // namespace frond::api
