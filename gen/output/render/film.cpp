#include "render/film.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>

#include "core/files.h"
#include "images/png_samples.h"
#include "render/animated_webp.h"
#include "render/place.h"
#include "render/process.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostLines = 6;  // that are shown of what ffmpeg says

/// What came of a call of ffmpeg.
struct Encoded {
  int status = 0;
  std::size_t fed = 0;  ///< pictures
  std::string words;
  Errors damaged;  ///< pictures that are not whole
};

/// ffmpeg with these arguments, and the pictures one after the other on its stdin. Where one is not whole it
/// gets no more and is ended, and the others are only looked at.
Encoded feed(const std::vector<fs::path>& pictures, std::vector<std::string> words) {
  Encoded result;
  OutputCapture said;
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return {1, 0, std::strerror(errno), {}};
  Descriptor from(ends[0]), to(ends[1]);
  Command command;
  command.words = std::move(words);
  command.in = *from;
  command.out = command.err = said.descriptor();
  Result<pid_t> process = start(command);
  from.close();
  if (!process) return {1, 0, process.errors()[0].text(), {}};
  auto before = ::signal(SIGPIPE, SIG_IGN);  // it may end before it has read all
  bool reads = true;
  for (const fs::path& path : pictures) {
    Result<std::string> bytes = whole_picture(path);
    if (!bytes) result.damaged.push_back(bytes.errors()[0]);
    if (!result.damaged.empty() || !reads) continue;
    reads = write_all(*to, *bytes);
    result.fed += reads;
  }
  if (!result.damaged.empty()) ::kill(*process, SIGKILL);
  to.close();
  ::signal(SIGPIPE, before);
  result.status = wait_for(*process);
  result.words = said.text();
  return result;
}

/// Whether a PNG has opacity: its kind of colour says.
bool has_opacity(const fs::path& picture) {
  constexpr std::size_t kColorType = 25;
  Result<std::string> bytes = read_file(picture);
  return bytes && bytes->size() > kColorType && ((*bytes)[kColorType] == 4 || (*bytes)[kColorType] == 6);
}

/// The lines of -progress are told from ffmpeg's own words by their `key=`.
bool is_progress(std::string_view line) {
  std::size_t end = line.find('=');
  return end != line.npos && end > 0 &&
         line.substr(0, end).find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == line.npos;
}

/// How many frames the last line of -progress says; -1 where none does.
int frames_of(std::string_view words) {
  constexpr std::string_view kKey = "frame=";
  int frames = -1;
  for (const std::string& line : lines_of(words)) {
    if (!line.starts_with(kKey)) continue;
    std::size_t at = std::min(line.find_first_not_of(' ', kKey.size()), line.size());
    std::from_chars(line.data() + at, line.data() + line.size(), frames);
  }
  return frames;
}

/// What is told of a call that failed: damaged pictures and ffmpeg's own words, and then what could not be
/// made of it.
Errors told(const Encoded& encoded, const std::string& what) {
  if (tells_full_disk(encoded.words)) return {{"", what + ": no room on the disk"}};
  Errors errors = encoded.damaged;
  std::size_t shown = 0;
  for (const std::string& line : lines_of(encoded.words))
    if (encoded.damaged.empty() && !is_progress(line) && shown++ < kMostLines) errors.push_back({"", line});
  return errors;
}

/// The first words of a call of ffmpeg that takes pictures from its stdin.
std::vector<std::string> reading(const std::string& ffmpeg, const std::string& fps) {
  return {ffmpeg,        "-hide_banner",     "-nostdin", "-loglevel",  "error",
          "-nostats",    "-progress",        "pipe:1",   "-xerror",    "-y",
          "-err_detect", "crccheck+explode", "-f",       "image2pipe", "-c:v",
          "png",         "-framerate",       fps,        "-i",         "pipe:0"};
}

using List = std::vector<std::string>;

void append_words(List& list, const List& more) { list.insert(list.end(), more.begin(), more.end()); }

/// How ffmpeg encodes a format. Of even size, BT.709 with tags: untagged, players guess other colours; 4:2:0,
/// but 4:4:4 in ProRes.
List codec(std::string_view format, bool alpha) {
  std::string_view pixels = format == "mov" ? "yuva444p10le" : alpha ? "yuva420p" : "yuv420p";
  const List even{
      "-vf",
      fmt::format("format={},pad=ceil(iw/2)*2:ceil(ih/2)*2:0:0:black{},"
                  "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,format={}",
                  alpha ? "gbrap" : "gbrp", alpha ? "@0" : "", pixels)};
  const List tags{"-color_range",     "tv",    "-colorspace", "bt709",
                  "-color_primaries", "bt709", "-color_trc",  "iec61966-2-1"};
  if (format == "gif")
    return {"-lavfi", "paletteuse=dither=bayer:bayer_scale=4:diff_mode=rectangle", "-fps_mode",
            "passthrough"};
  List list = even;
  bool h264 = format != "mov" && format != "webm";
  if (format == "mov")
    append_words(list, {"-c:v", "prores_ks", "-profile:v", "4444", "-alpha_bits", alpha ? "16" : "0",
                        "-vendor", "apl0"});
  if (format == "webm" && alpha) append_words(list, {"-auto-alt-ref", "0"});
  if (format == "webm")
    append_words(list, {"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-deadline", "good", "-cpu-used",
                        "2", "-threads", "4"});
  if (h264) append_words(list, {"-c:v", "libx264", "-preset", "slow", "-crf", "16", "-threads", "4"});
  append_words(list, tags);
  if (h264) append_words(list, {"-movflags", "+faststart"});  // the header first
  return list;
}

std::string file_word(const fs::path& path) { return "file:" + path.string(); }

/// Encodes it as `part`; `palette` is a file for the colours of a GIF.
Encoded encode(const FilmJob& job, const std::string& format, const fs::path& part, const fs::path& palette) {
  List words = reading(job.ffmpeg, job.fps);
  if (format == "gif") {
    List first = words;
    append_words(first, {"-vf", "palettegen=stats_mode=diff", "-update", "1", "-c:v", "png", "-f", "image2",
                         file_word(palette)});
    Encoded colors = feed(job.pictures, first);
    if (colors.status != 0 || !colors.damaged.empty()) return colors;
    append_words(words, {"-i", file_word(palette)});
  }
  append_words(words, codec(format, job.alpha));
  append_words(words,
               {"-fflags", "+bitexact", "-flags:v", "+bitexact", "-map_metadata", "-1", "-metadata",
                "title=" + job.title, "-metadata", "comment=" + job.comment, "-f", format, file_word(part)});
  return feed(job.pictures, words);
}

std::string format_of(const fs::path& film) {
  std::string ending = film.extension();
  bool known = ending == ".webm" || ending == ".gif" || ending == ".mov" || ending == ".webp";
  return known ? ending.substr(1) : "mp4";
}

/// By libwebp, which ffmpeg of Debian 12 does not read again.
Errors encode_webp(const FilmJob& job) {
  Result<std::string> film = animated_webp(job.pictures, job.fps, job.title, job.comment);
  if (film) return put_text(part_of(job.film), job.film, *film);
  Errors errors = film.errors();
  errors.push_back({"", job.film.string() + " could not be encoded"});
  return errors;
}

/// Removes a file when it goes out of sight.
struct Remover {
  fs::path path;
  ~Remover() { ::unlink(path.c_str()); }
};

}  // namespace

std::string gif_with_comment(std::string_view gif, std::string_view comment) {
  constexpr std::size_t kHead = 13, kFlags = 10, kBlock = 255;
  if (gif.size() <= kHead) return std::string(gif);
  auto flags = static_cast<unsigned char>(gif[kFlags]);
  std::size_t at = kHead + (flags & 128 ? std::size_t{3} << ((flags & 7) + 1) : 0);
  std::string text(gif.substr(0, at));
  text += "\x21\xfe";
  while (!comment.empty()) {
    std::string_view block = comment.substr(0, kBlock);
    text += static_cast<char>(block.size());
    text += block;
    comment.remove_prefix(block.size());
  }
  text += '\0';
  return text += gif.substr(std::min(at, gif.size()));
}

Errors encode_film(const FilmJob& job) {
  std::string format = format_of(job.film), film = job.film.string();
  if (format == "webp") return encode_webp(job);
  Remover part{part_of(job.film)}, palette{part.path.string() + ".png"};
  ::unlink(palette.path.c_str());
  Encoded encoded = encode(job, format, part.path, palette.path);
  int frames = frames_of(encoded.words);
  bool whole =
      encoded.status == 0 && encoded.damaged.empty() && frames == static_cast<int>(job.pictures.size());
  if (!whole) {
    Errors errors = told(encoded, film + " could not be encoded");
    if (errors.empty() || !tells_full_disk(encoded.words))
      errors.push_back(error_at("", "{} could not be encoded: {} of {} frames", film, std::max(frames, 0),
                                job.pictures.size()));
    return errors;
  }
  std::string comment = job.title + (job.title.empty() || job.comment.empty() ? "" : "; ") + job.comment;
  if (format == "gif" && !comment.empty()) {
    Result<std::string> gif = read_file(part.path);
    if (!gif) return gif.errors();
    return put_text(part.path, job.film, gif_with_comment(*gif, comment));
  }
  return put_in_place(part.path, job.film);
}

std::string over_checks() {
  auto laid = [](char channel) {
    return fmt::format("{0}='{0}(X,Y)+(255-alpha(X,Y))/255*(153+51*mod(floor(X/8)+floor(Y/8),2))'", channel);
  };
  return fmt::format("geq={}:{}:{}", laid('r'), laid('g'), laid('b'));
}

Errors tile_sheet(const SheetJob& job) {
  if (job.pictures.empty()) return {{"", job.sheet.string() + ": no pictures for it"}};
  Remover part{part_of(job.sheet)};
  std::string what = job.sheet.string() + " could not be made";
  auto rows = (job.pictures.size() + static_cast<std::size_t>(job.columns) - 1) /
              static_cast<std::size_t>(job.columns);
  // With opacity, colours of what is hardly there are made small with the rest: they count by their share.
  bool open = has_opacity(job.pictures[0]);
  std::string small = fmt::format("scale='min(iw,{})':-1", job.width);
  small = open ? fmt::format("format=gbrap,premultiply=inplace=1,{},format=gbrap,{},format=gbrp", small,
                             over_checks())
               : "format=gbrp," + small;
  List words = reading(job.ffmpeg, "1");
  append_words(
      words,
      {"-vf",
       fmt::format("{},tile={}x{}:padding=4:margin=4:color=0x202020,format=rgb24", small, job.columns, rows),
       "-frames:v", "1", "-update", "1", "-c:v", "png", "-f", "image2", file_word(part.path)});
  Encoded made = feed(job.pictures, words);
  if (!made.damaged.empty()) return {{"", what + ": " + made.damaged[0].text()}};
  if (made.status != 0 || !whole_picture(part.path)) {
    Errors errors = told(made, what);
    if (!tells_full_disk(made.words)) errors.push_back({"", what});
    return errors;
  }
  return put_in_place(part.path, job.sheet);
}

Errors copy_picture(const fs::path& picture, const fs::path& to, double dpi) {
  Result<std::string> bytes = whole_picture(picture);
  if (!bytes) return bytes.errors();
  return put_text(part_of(to), to, dpi > 0 ? with_density(*bytes, dpi) : *bytes);
}

int frames_in(const fs::path& film, const std::string& ffmpeg, double fps) {
  if (format_of(film) == "webp") {
    Result<std::string> bytes = read_file(film);
    return bytes ? static_cast<int>(std::lround(milliseconds_in_webp(*bytes) * fps / 1000)) : 0;
  }
  OutputCapture said;
  Command command;
  command.words = {ffmpeg,      "-hide_banner",  "-nostdin", "-loglevel", "quiet", "-nostats",
                   "-i",        file_word(film), "-map",     "0:v",       "-c",    "copy",
                   "-progress", "pipe:1",        "-f",       "null",      "-"};
  command.out = said.descriptor();
  Result<int> status = run(command);
  return status ? std::max(frames_of(said.text()), 0) : 0;
}

}  // namespace frond
