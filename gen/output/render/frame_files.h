#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>

namespace frond {

/// The frame that an unfinished file is of: `frame_0001` of `.frame_0001.KEY.kept`. Empty for others.
std::string unfinished_frame(const std::filesystem::path& file);

/// What lies beside a picture while it is unfinished: `.frame_0001.KEY.` and an ending, where the key stands
/// for all that the picture is made of.
class FrameFiles {
 public:
  /// Those of one scene that is drawn.
  struct Exposure {
    std::filesystem::path part;     ///< the picture
    std::filesystem::path state;    ///< POV-Ray's notes of the blocks that it has traced, as it calls them
    std::filesystem::path kept;     ///< another name of these
    std::filesystem::path exposed;  ///< the picture of one of several exposures, once it is whole
  };

  FrameFiles(std::filesystem::path folder, std::string name, const std::string& key, std::size_t exposures);

  Exposure exposure(std::size_t index) const;

  std::filesystem::path plain;  ///< the picture on its way to its place
  std::filesystem::path log;    ///< what POV-Ray says
  std::filesystem::path large;  ///< the folder where POV-Ray keeps the pixels of a large picture
  std::filesystem::path spent;  ///< what earlier runs took for it

  /// Removes what lies there of other pictures of that name, links, and what cannot be gone on with.
  void remove_others() const;

  /// The milliseconds that earlier runs took for it; nothing where one was killed before it said. For the
  /// time being it is noted that nothing is known.
  std::optional<long> begin_time() const;
  void note_time(std::optional<long> milliseconds) const;

  /// Gives POV-Ray its notes of an earlier run under the name that it looks for. POV-Ray removes its state
  /// before it writes the picture, which takes long if that is large, so there is a second name. False where
  /// nothing can be written.
  bool keep_notes(const Exposure& names) const;

  /// Whether the disk has no room for what a picture of that size needs, or 16 MB: POV-Ray does not tell.
  bool disk_is_full(std::array<int, 2> size) const;

  void remove_unfinished(const Exposure& names) const;
  void remove_all() const;

 private:
  /// Removes what begins with the frame's name, but for those of the key where they are to stay.
  void remove(bool ours_too) const;

  std::filesystem::path folder_;
  std::string name_, base_;
  bool many_;
};

}  // namespace frond
