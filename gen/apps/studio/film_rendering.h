#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "frond/frond.h"

namespace frond {

/// Renders films of the preset in a file, until `stop` becomes true, and tells what is said meanwhile.
class FilmRendering final : public api::Listener {
 public:
  using Said = std::function<void(std::string_view line)>;
  FilmRendering(std::filesystem::path preset, const std::atomic<bool>& stop, Said said)
      : preset_(std::move(preset)), stop_(stop), said_(std::move(said)) {}

  /// Into a folder, with `/json/pointer=value` overrides; `frames` are A-B, or empty: all; an empty format is
  /// the usual one. What went wrong; empty where nothing did, and where it was stopped.
  std::string render(const std::filesystem::path& folder, const std::vector<std::string>& sets,
                     const std::string& frames, std::string_view format, bool watch);

  void note(std::string_view line) override { said_(line); }
  void rendered(int, int, std::string_view words) override { said_(words); }
  bool cancelled() override { return stop_; }

 private:
  std::filesystem::path preset_;
  const std::atomic<bool>& stop_;
  Said said_;
};

}  // namespace frond
