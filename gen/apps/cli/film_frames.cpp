#include "cli/film_frames.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace frond {

namespace fs = std::filesystem;

namespace {

/// Reads until the buffer is full or nothing more comes; how much was read.
std::size_t read_all(int file, std::uint8_t* data, std::size_t size) {
  std::size_t got = 0;
  while (got < size) {
    ssize_t more = ::read(file, data + got, size - got);
    if (more < 0 && errno == EINTR) continue;
    if (more <= 0) break;
    got += static_cast<std::size_t>(more);
  }
  return got;
}

}  // namespace

FilmFrames::FilmFrames(const fs::path& film, std::array<int, 2> size, const std::string& rate)
    : name_(film.string()), size_(size) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) {
    errors_ = {{"", std::strerror(errno)}};
    return;
  }
  std::error_code error;
  Command command;
  command.words = {environment_or("FROND_FFMPEG", "ffmpeg"),
                   "-hide_banner",
                   "-nostdin",
                   "-loglevel",
                   "error",
                   "-r",
                   rate,
                   "-i",
                   "file:" + fs::absolute(film, error).string(),
                   "-map",
                   "0:v:0",
                   "-sws_flags",
                   "bicubic+accurate_rnd+full_chroma_int",
                   "-f",
                   "rawvideo",
                   "-pix_fmt",
                   "rgb24",
                   "pipe:1"};
  command.out = ends[1];
  command.err = said_.descriptor();
  Result<pid_t> process = start(command);
  ::close(ends[1]);
  file_ = ends[0];
  if (process)
    process_ = *process;
  else
    errors_ = process.errors();
}

FilmFrames::~FilmFrames() {
  if (file_ >= 0) ::close(file_);
  if (process_ >= 0) wait_for(process_);  // which ends, as nobody reads it
}

std::optional<Raster> FilmFrames::next() {
  if (process_ < 0) return std::nullopt;
  Raster raster(size_[0], size_[1], 3);
  std::size_t got = read_all(file_, raster.data.data(), raster.data.size());
  if (got == raster.data.size()) return raster;
  int code = wait_for(process_);
  process_ = -1;
  if (code != 0 || got != 0) errors_ = {{"", name_ + " is damaged: " + said_.text()}};
  return std::nullopt;
}

}  // namespace frond
