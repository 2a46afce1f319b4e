#include "studio/film_rendering.h"

#include "pipeline/frame_range.h"
#include "render/process.h"

namespace frond {

std::string FilmRendering::render(const std::filesystem::path& folder, const std::vector<std::string>& sets,
                                  const std::string& frames, std::string_view format, bool watch) {
  try {
    api::Preset preset = api::Preset::read(preset_);
    for (const std::string& set : sets) {
      std::size_t equals = set.find('=');
      preset.set(set.substr(0, equals), set.substr(equals + 1));
    }
    api::RenderOptions options{.format = std::string(format), .watch = watch, .program = own_program()};
    if (!frames.empty()) {
      Result<FrameRange> range = read_frames(frames, preset.frames());
      if (!range) return range.errors().front().text();
      options.frames = {range->first, range->last};
    }
    api::render(preset, folder, options, this);
  } catch (const api::Cancelled&) {
  } catch (const api::Failure& failure) {
    const api::Message& last = failure.messages().back();
    return last.where.empty() ? last.what : last.where + ": " + last.what;
  }
  return {};
}

}  // namespace frond
