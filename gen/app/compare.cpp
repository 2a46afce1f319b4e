#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

#include "app/bar.h"
#include "app/commands.h"
#include "app/messages.h"
#include "app/streams.h"
#include "app/work_folder.h"
#include "core/files.h"
#include "render/label.h"
#include "render/place.h"
#include "render/process.h"

// Two films or two pictures side by side, with their difference: render --compare.

namespace frond {

namespace fs = std::filesystem;

namespace {

/// A film or a picture that is compared.
struct Side {
  fs::path file;
  std::string size, rate;  ///< "64,48" pixels; frames a second
  bool picture() const { return file.extension() == ".png"; }
};

/// The film or picture that a path stands for.
Result<fs::path> found(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) {
    for (const char* name : {"film.mp4", "film.webm", "film.gif", "still.png"})
      if (fs::is_regular_file(fs::path(path) / name, error)) return fs::path(path) / name;
    return Error{"", path + ": a folder without film or still"};
  }
  if (!fs::is_regular_file(path, error)) return Error{"", path + ": no such film or picture"};
  std::string type = fs::path(path).extension();
  if (type != ".png" && type != ".mp4" && type != ".webm" && type != ".gif")
    return Error{"", path + ": expected .png, .mp4, .webm or .gif"};
  return fs::path(path);
}

/// Its size and rate; an error where it is damaged.
Errors describe(Side& side) {
  Words said;
  Command command;
  command.words = {"ffprobe",
                   "-v",
                   "quiet",
                   "-select_streams",
                   "v:0",
                   "-show_entries",
                   "stream=width,height,r_frame_rate",
                   "-of",
                   "csv=p=0",
                   "file:" + side.file.string()};
  command.out = said.descriptor();
  Result<int> code = run(command);
  std::string text = said.text();
  text = text.substr(0, text.find('\n'));
  std::size_t comma = text.rfind(',');
  if (!code || *code != 0 || comma == text.npos) return {{"", side.file.string() + " is damaged"}};
  side.size = text.substr(0, comma);
  side.rate = text.substr(comma + 1);
  return {};
}

/// What ffmpeg's filter has counted of the difference, in words.
std::string in_words(const std::string& figures, bool film) {
  int frames = 0, differ = 0, worst = 0;
  double most = 0;
  for (const std::string& line : lines_of(figures)) {
    auto value = [&](std::string_view key) {
      std::size_t at = line.find(key);
      double number = 0;
      if (at != line.npos) std::from_chars(line.data() + at + key.size(), line.data() + line.size(), number);
      return number;
    };
    ++frames;
    double mse = value("mse_avg:");
    if (line.find("psnr_avg:inf") != line.npos) continue;
    ++differ;
    if (mse >= most) most = mse, worst = static_cast<int>(value("n:"));
  }
  if (differ == 0) return "No pixel differs.";
  if (film)
    return fmt::format("{} of {} frames differ, most of all frame {}: by {:.2g} of 255 (RMSE).", differ,
                       frames, worst, std::sqrt(most));
  return fmt::format("They differ by {:.2g} of 255 (RMSE).", std::sqrt(most));
}

/// The three pictures side by side, as ffmpeg's filters.
std::string graph(const Labels& labels, bool film) {
  std::string last =
      film ? "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p"
           : "format=rgb24";
  return "[0:v]format=gbrp,split=3[a1][a2][a3];[1:v]format=gbrp,split=3[b1][b2][b3];"
         "[a1][b1]psnr=stats_file=figures:shortest=1,nullsink;"
         "[a2][b2]blend=all_mode=difference:shortest=1,lutrgb=r=val*4:g=val*4:b=val*4,format=rgb24," +
         labels.filter("d") + "[d];[a3]format=rgb24," + labels.filter("a") + "[a];[b3]format=rgb24," +
         labels.filter("b") + "[b];[a][b][d]hstack=3:shortest=1," + last;
}

Errors make_comparison(const Side& a, const Side& b, const fs::path& out, std::string& words) {
  WorkFolder work;
  if (work.path().empty()) return {{"", "no folder can be made for the labels"}};
  int width = size_of(fmt::format("{}x1", a.size.substr(0, a.size.find(','))))[0];
  Labels labels(work.path());
  for (const auto& [name, text] : {std::pair<const char*, std::string>("a", a.file.string()),
                                   std::pair<const char*, std::string>("b", b.file.string()),
                                   std::pair<const char*, std::string>("d", "difference x 4")})
    if (Errors errors = labels.add(name, text, width); !errors.empty()) return errors;
  bool film = !a.picture();
  fs::path part = part_of(out);
  std::error_code error;
  Words said;
  Command command;
  command.folder = work.path();
  command.out = command.err = said.descriptor();
  command.words = {
      environment_or("FROND_FFMPEG", "ffmpeg"), "-hide_banner", "-nostdin", "-loglevel", "error", "-y"};
  auto add = [&](std::initializer_list<std::string> list) {
    command.words.insert(command.words.end(), list.begin(), list.end());
  };
  for (const Side* side : {&a, &b}) {
    if (film) add({"-r", a.rate});  // frame by frame, whatever their clocks say
    add({"-i", "file:" + fs::absolute(side->file, error).string()});
  }
  add({"-lavfi", graph(labels, film)});
  if (film)
    add({"-c:v", "libx264", "-preset", "medium", "-crf", "16", "-color_range", "tv", "-colorspace", "bt709",
         "-color_primaries", "bt709", "-f", "mp4"});
  else
    add({"-frames:v", "1", "-update", "1", "-c:v", "png", "-f", "image2"});
  add({"file:" + part.string()});
  Result<int> code = run(command);
  if (!code || *code != 0) {
    fs::remove(part, error);
    std::string why = tells_full_disk(said.text()) ? "no room on the disk" : said.text();
    return {{"", out.string() + " could not be made: " + why}};
  }
  Result<std::string> figures = read_file(work.path() / "figures");
  words = in_words(figures ? *figures : "", film);
  return put_in_place(part, out);
}

}  // namespace

int compare(const std::vector<std::string>& paths) {
  auto wrong = [](const std::string& what) { return fail_run({{"", what}}, kWrongInput); };
  if (paths.size() < 2 || paths.size() > 3) return wrong("--compare: expected A B [FILE]");
  Side sides[2];
  for (std::size_t i = 0; i < 2; ++i) {
    Result<fs::path> file = found(paths[i]);
    if (!file) return fail_run(file.errors(), kWrongInput);
    sides[i].file = *file;
  }
  const auto& [a, b] = sides;
  if (a.picture() != b.picture())
    return wrong(a.file.string() + " and " + b.file.string() + ": expected two films or two pictures");
  std::string ending = a.picture() ? ".png" : ".mp4";
  fs::path out = paths.size() > 2 ? fs::path(paths[2]) : fs::path("out/compare" + ending);
  if (out.extension() != ending) return wrong(out.string() + ": expected a name that ends in " + ending);
  for (Side& side : sides)
    if (Errors errors = describe(side); !errors.empty()) return fail_run(errors, kCouldNot);
  if (a.size != b.size)
    return wrong(fmt::format("{} is of {} pixels, {} of {}; expected one size", a.file.string(), a.size,
                             b.file.string(), b.size));
  std::error_code error;
  out = fs::absolute(out, error).lexically_normal();
  fs::create_directories(out.parent_path(), error);
  if (error) return fail_run({{"", out.string() + ": its folder cannot be made"}}, kCouldNot);
  std::string words;
  if (Errors errors = make_comparison(a, b, out, words); !errors.empty()) return fail_run(errors, kCouldNot);
  say(words);
  put(out.string() + "\n");
  return kDone;
}

}  // namespace frond
