#include "render/film.h"

#include "cli/commands.h"
#include "cli/messages.h"
#include "core/files.h"
#include "core/read_as.h"
#include "render/process.h"

// Films and sheets of finished pictures: film.

namespace frond {

namespace {

Errors make(const FilmArguments& arguments, std::vector<std::filesystem::path> pictures) {
  std::string ffmpeg = environment_or("FROND_FFMPEG", "ffmpeg");
  std::filesystem::path file = arguments.file;
  if (is_folder(file)) return {{"", arguments.file + " is a folder; expected a file, or none"}};
  if (arguments.columns > 0)
    return tile_sheet({std::move(pictures), file, arguments.columns, arguments.width, ffmpeg});
  if (file.extension() == ".png") return copy_picture(pictures[0], file, arguments.dpi);
  return encode_film({std::move(pictures), file, arguments.fps, arguments.title, arguments.comment, ffmpeg,
                      arguments.alpha});
}

}  // namespace

void film(const FilmArguments& arguments) {
  std::string list = or_fail_run(read_file(arguments.list), kCouldNot);
  std::vector<std::filesystem::path> pictures;
  for (std::string& line : lines_of(list)) pictures.emplace_back(std::move(line));
  if (pictures.empty()) fail_run({{arguments.list, "names no picture; expected one a line"}}, kWrongInput);
  if (!(read_as<double>(arguments.fps).value_or(0) > 0))
    fail_run({{"--fps", "\"" + arguments.fps + "\" is no number above 0"}}, kWrongInput);
  or_fail_run(make(arguments, std::move(pictures)), kCouldNot);
}

}  // namespace frond
