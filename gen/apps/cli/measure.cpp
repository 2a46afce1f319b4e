#include "cli/measure.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <map>
#include <optional>
#include <string_view>

#include "core/files.h"
#include "core/frame_name.h"
#include "core/text.h"
#include "images/raster.h"
#include "render/place.h"
#include "render/process.h"

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

/// The frames of a film, one after the other, as ffmpeg decodes them.
class FilmFrames {
 public:
  /// `size` in pixels; `rate` is the film's own in frames a second, as ffmpeg writes it: each frame is given
  /// once, whatever the film's clock says.
  FilmFrames(const std::filesystem::path& film, std::array<int, 2> size, const std::string& rate);
  ~FilmFrames();

  /// The next frame; nothing at the end, and where there is none to be had, see errors().
  std::optional<Raster> next();

  /// Why the film ended, or did not begin, where it is damaged.
  const Errors& errors() const { return errors_; }

 private:
  std::string name_;
  std::array<int, 2> size_;
  OutputCapture said_;
  pid_t process_ = -1;
  int file_ = -1;
  Errors errors_;
};

FilmFrames::FilmFrames(const fs::path& film, std::array<int, 2> size, const std::string& rate)
    : name_(film.string()), size_(size) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) {
    errors_ = {{"", std::strerror(errno)}};
    return;
  }
  std::error_code error;
  Command command;
  command.words = {environment_or("FROND_FFMPEG", "ffmpeg"), "-hide_banner", "-nostdin", "-loglevel",
                   "error"};
  command.add({"-r", rate, "-i", "file:" + fs::absolute(film, error).string(), "-map", "0:v:0", "-sws_flags",
               "bicubic+accurate_rnd+full_chroma_int", "-f", "rawvideo", "-pix_fmt", "rgb24", "pipe:1"});
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

/// The number in the name of a frame's picture: 12 of "frame_0012.png"; 0 of any other name.
int number_in_name(const std::string& name) {
  std::string_view digits = name;
  if (!digits.starts_with("frame_") || !digits.ends_with(".png")) return 0;
  digits = digits.substr(6, digits.size() - 10);
  int number = counting_number(digits);
  return number > 0 && name == frame_name(number) + ".png" ? number : 0;
}

/// The frames in a folder by their numbers.
std::map<int, fs::path> numbered_pictures(const fs::path& folder) {
  std::map<int, fs::path> frames;
  for (const fs::path& path : files_in(folder))
    if (int number = number_in_name(path.filename().string())) frames.emplace(number, path);
  return frames;
}

/// Reads a picture; where it is none, the errors of what is measured say so.
std::optional<SeenPicture> read_picture(const fs::path& file, Measured& measured) {
  Result<std::string> bytes = whole_picture(file);
  Result<SeenPicture> picture = bytes ? read_seen_png(*bytes) : Result<SeenPicture>(bytes.errors());
  if (picture) return std::move(*picture);
  measured.errors = picture.errors();
  if (measured.errors[0].where.empty() && bytes) measured.errors[0].where = file.string();
  measured.code = kCouldNot;
  return std::nullopt;
}

/// Two pictures are the next frame. False where they are not of one size, or of another than those before.
bool add_pictures(const fs::path& a, const fs::path& b, int number, std::array<int, 2>& size,
                  Measured& measured) {
  std::optional<SeenPicture> pictures[2];
  for (std::size_t i = 0; i < 2; ++i) {
    const fs::path& file = i == 0 ? a : b;
    pictures[i] = read_picture(file, measured);
    if (!pictures[i]) return false;
    std::array<int, 2> own{pictures[i]->width, pictures[i]->height};
    if (size == std::array{0, 0}) size = own;
    if (own == size) continue;
    measured.errors = {error_at("", "{} is of {}x{} pixels, {} of {}x{}; expected one size", file.string(),
                                own[0], own[1], i == 0 ? "those before it" : a.string(), size[0], size[1])};
    return false;
  }
  measured.differ.add(*pictures[0], *pictures[1]);
  measured.numbers.push_back(number);
  return true;
}

/// A number of the figures, for people.
std::string short_text(double value) { return number_text(value, value < 1 ? 3 : 2); }

}  // namespace

fs::path folder_of_frames(const fs::path& folder) {
  for (const fs::path& place : {folder / "frames", folder})
    if (!numbered_pictures(place).empty()) return place;
  return {};
}

Measured measure_pictures(const fs::path& a, const fs::path& b) {
  Measured measured;
  measured.film = false;
  std::array<int, 2> size{};
  add_pictures(a, b, 1, size, measured);
  return measured;
}

Measured measure_frames(const fs::path& a, const fs::path& b) {
  Measured measured;
  std::map<int, fs::path> ours = numbered_pictures(a), theirs = numbered_pictures(b);
  std::array<int, 2> size{};
  for (const auto& [number, path] : ours)
    if (auto other = theirs.find(number); other != theirs.end())
      if (!add_pictures(path, other->second, number, size, measured)) return measured;
  int both = measured.differ.frames();
  measured.left_out = static_cast<int>(ours.size() + theirs.size()) - 2 * both;
  if (both == 0)
    measured.errors = {error_at("", "{} and {} have no frame of one number", a.string(), b.string())};
  return measured;
}

Measured measure_films(const MeasuredFilm& a, const MeasuredFilm& b) {
  Measured measured;
  FilmFrames ours(a.file, a.size, a.rate), theirs(b.file, b.size, b.rate);
  std::optional<Raster> one = ours.next(), other = theirs.next();
  for (; one && other; one = ours.next(), other = theirs.next()) {
    measured.differ.add(seen(*one), seen(*other));
    measured.numbers.push_back(measured.differ.frames());
  }
  for (; one; one = ours.next()) ++measured.left_out;
  for (; other; other = theirs.next()) ++measured.left_out;
  for (const FilmFrames* film : {&ours, &theirs})
    measured.errors.insert(measured.errors.end(), film->errors().begin(), film->errors().end());
  if (measured.errors.empty() && measured.differ.frames() == 0)
    measured.errors = {{"", "there is no frame that both films have"}};
  measured.code = kCouldNot;
  return measured;
}

std::string figures_in_words(const Measured& measured) {
  const Differ& differ = measured.differ;
  std::string left_out = measured.left_out > 0
                             ? fmt::format(" Not counted: frames that only one has, {}.", measured.left_out)
                             : "";
  if (differ.differing() == 0) return "No pixel differs." + left_out;
  Difference all = differ.total();
  std::string off =
      fmt::format("by {} of 255 (RMSE), at most by {}, and by more than 8 in {} % of the pixels",
                  short_text(all.error), short_text(all.maximum), short_text(100 * all.share));
  if (!measured.film) return "They differ " + off + ".";
  int worst = measured.numbers[static_cast<std::size_t>(differ.worst() - 1)];
  return fmt::format(
      "{} of {} frames differ, most of all frame {}: by {} of 255 (RMSE). All in all they differ {}; the "
      "difference flickers by {} of 255.{}",
      differ.differing(), differ.frames(), worst, short_text(differ.worst_error()), off,
      short_text(differ.flicker()), left_out);
}

std::string figures_as_json(const Measured& measured) {
  const Differ& differ = measured.differ;
  Difference all = differ.total();
  std::string film;
  if (measured.film) {
    int worst = differ.worst() > 0 ? measured.numbers[static_cast<std::size_t>(differ.worst() - 1)] : 0;
    film = fmt::format(
        ", \"flicker\": {}, \"frames\": {}, \"frames_that_differ\": {}, \"frames_left_out\": {}, "
        "\"worst_frame\": {}, \"worst_error\": {}",
        number_text(differ.flicker(), 6), differ.frames(), differ.differing(), measured.left_out, worst,
        number_text(differ.worst_error(), 6));
  }
  return fmt::format("{{\"error\": {}, \"maximum\": {}, \"share_beyond_8\": {}{}}}\n",
                     number_text(all.error, 6), number_text(all.maximum, 6), number_text(all.share, 6), film);
}

}  // namespace frond
