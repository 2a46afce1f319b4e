#include "render/jpeg.h"

#include <fmt/format.h>

#include "core/files.h"
#include "render/process.h"

namespace frond {

namespace fs = std::filesystem;

std::string sheet_layout(std::size_t pictures, int columns, std::array<int, 2> size) {
  constexpr int kGap = 4;
  std::string layout;
  for (int i = 0; i < static_cast<int>(pictures); ++i)
    layout +=
        fmt::format("{}{}_{}", i ? "|" : "", i % columns * (size[0] + kGap), i / columns * (size[1] + kGap));
  return layout;
}

Errors write_jpeg(const JpegJob& job, const fs::path& scratch, const fs::path& file) {
  remove_file(scratch);
  Command command;
  command.words = {job.ffmpeg, "-y", "-nostdin", "-loglevel", "error"};
  for (const fs::path& picture : job.pictures) command.add({"-i", "file:" + picture.string()});
  if (job.pictures.size() > 1)
    command.add({"-filter_complex", fmt::format("xstack=inputs={}:layout={}:fill=white", job.pictures.size(),
                                                sheet_layout(job.pictures.size(), job.columns, job.size))});
  command.add({"-bitexact", "-q:v", "3", "-c:v", "mjpeg", "-f", "image2", "-update", "1",
               "file:" + scratch.string()});
  Result<int> code = run(command);
  if (!code) return code.errors();
  Result<std::string> bytes = *code == 0 ? read_file(scratch) : Error{};
  if (!bytes || bytes->empty()) return {{"", file.string() + " could not be made"}};
  Result<bool> written = write_file(file, *bytes);
  return written ? Errors{} : written.errors();
}

}  // namespace frond
