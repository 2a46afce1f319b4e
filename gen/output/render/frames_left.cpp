#include "render/frames_left.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/files.h"
#include "core/frame_name.h"
#include "render/frame_files.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

constexpr double kBytesAPixel = 20;
constexpr double kPictureWeight = 500, kSceneWeight = 500;  // on the average

double size_of_file(const fs::path& path) {
  std::error_code error;
  auto size = fs::file_size(path, error);
  return error ? 0 : static_cast<double>(size);
}

}  // namespace

FramesLeft::FramesLeft(const fs::path& frames, fs::path drawn, std::array<int, 2> size,
                       const std::vector<int>& numbers, int at_once, double now)
    : folder_(std::move(drawn)),
      picture_bytes_(kBytesAPixel * size[0] * size[1]),
      began_(now),
      at_once_(std::min(at_once, std::max<int>(1, static_cast<int>(numbers.size())))) {
  double mean = 0;
  for (int number : numbers) {
    Frame frame{std::max(1.0, size_of_file(frames / (frame_name(number) + ".pov"))), 1};
    while (path_exists(frames / (exposure_name(number, frame.exposures + 1) + ".pov"))) ++frame.exposures;
    mean += frame.weight / static_cast<double>(numbers.size());
    frames_[frame_name(number)] = frame;
  }
  for (auto& [name, frame] : frames_) {
    frame.weight = kPictureWeight + kSceneWeight * frame.weight / mean;
    all_ += frame.weight;
  }
}

void FramesLeft::frame_done(int number) {
  auto found = frames_.find(frame_name(number));
  if (found != frames_.end()) done_ += found->second.weight;
  ++frames_done_;
}

void FramesLeft::look(double now) {
  noted_ = 0;
  for (const fs::path& path : files_in(folder_)) {
    std::string type = path.extension();
    if (type != ".kept" && type != ".exposed") continue;
    auto found = frames_.find(unfinished_frame(path));
    if (found == frames_.end()) continue;
    double share = type == ".exposed" ? 1 : std::min(1.0, size_of_file(path) / picture_bytes_);
    noted_ += found->second.weight * share / found->second.exposures;
  }
  if (!noted_before_) noted_before_ = noted_;
  if (noted_ > *noted_before_ && !read_) read_ = now;
}

int FramesLeft::percent() const {
  return all_ > 0 ? static_cast<int>((done_ + noted_) * 100 / all_ + 0.5) : 0;
}

std::optional<double> FramesLeft::seconds_left(double now) const {
  constexpr double kLeast = 2;  // seconds of tracing that tell something
  double before = noted_before_.value_or(0), far = done_ + noted_ - before;
  if (far <= 0) return std::nullopt;
  if (frames_done_ > 0) return std::max(0.0, (now - began_) * (all_ - done_ - noted_) / far);
  if (!read_ || now - *read_ < kLeast) return std::nullopt;
  // Each frame takes the time of reading, and then that of tracing.
  double weight = all_ / static_cast<double>(frames_.size());
  double frame = *read_ - began_ + (now - *read_) * at_once_ * weight / far;
  return std::max(0.0, frame * (all_ - before) / weight / at_once_ - (now - began_));
}

std::string clock_text(double seconds) {
  long whole = static_cast<long>(seconds);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace frond
