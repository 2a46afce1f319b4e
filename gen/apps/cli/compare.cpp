#include <fmt/format.h>

#include <algorithm>

#include "cli/bar.h"
#include "cli/commands.h"
#include "cli/measure.h"
#include "cli/messages.h"
#include "cli/streams.h"
#include "core/files.h"
#include "core/work_folder.h"
#include "jobs/jobs.h"
#include "render/label.h"
#include "render/place.h"
#include "render/process.h"

// Two films or two pictures in figures and side by side, with their difference: compare, render --compare.

namespace frond {

namespace fs = std::filesystem;

namespace {

/// A film or a picture that is compared.
struct Side {
  fs::path file;
  std::string size, rate;  ///< "64,48" pixels; frames a second
  bool picture() const { return file.extension() == ".png"; }
};

constexpr std::string_view kUnread = "webp";  // the format of films that ffmpeg of Debian 12 does not read

/// The film or picture that a path stands for.
Result<fs::path> found(const std::string& path) {
  if (is_folder(path)) {
    for (const std::string& name : result_files())
      if (name != "contact.png" && name != film_file(kUnread) && is_file(fs::path(path) / name))
        return fs::path(path) / name;
    return Error{"", path + ": a folder without film or still"};
  }
  if (!is_file(path)) return Error{"", path + ": no such film or picture"};
  std::string type = fs::path(path).extension();
  auto is_its = [&](std::string_view format) {
    return format != kUnread && type == "." + std::string(format);
  };
  if (type != ".png" && std::ranges::none_of(kFilmFormats, is_its))
    return Error{"", path + ": expected .png, .mp4, .mov, .webm or .gif"};
  return fs::path(path);
}

/// Finds the size and rate of a film or picture; an error where its file is damaged.
Errors describe(Side& side) {
  OutputCapture said;
  Command command;
  command.words = {"ffprobe", "-v", "quiet", "-select_streams", "v:0"};
  command.add(
      {"-show_entries", "stream=width,height,r_frame_rate", "-of", "csv=p=0", "file:" + side.file.string()});
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

/// The three pictures side by side, as ffmpeg's filters.
std::string graph(const Labels& labels, bool film) {
  std::string last =
      film ? "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p"
           : "format=rgb24";
  return "[0:v]format=gbrp,split=2[a2][a3];[1:v]format=gbrp,split=2[b2][b3];"
         "[a2][b2]blend=all_mode=difference:shortest=1,lutrgb=r=val*4:g=val*4:b=val*4,format=rgb24," +
         labels.filter("d") + "[d];[a3]format=rgb24," + labels.filter("a") + "[a];[b3]format=rgb24," +
         labels.filter("b") + "[b];[a][b][d]hstack=3:shortest=1," + last;
}

Errors make_comparison(const Side& a, const Side& b, const fs::path& out) {
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
  OutputCapture said;
  Command command;
  command.folder = work.path();
  command.out = command.err = said.descriptor();
  command.words = {
      environment_or("FROND_FFMPEG", "ffmpeg"), "-hide_banner", "-nostdin", "-loglevel", "error", "-y"};
  for (const Side* side : {&a, &b}) {
    if (film) command.add({"-r", a.rate});  // frame by frame, whatever their clocks say
    command.add({"-i", "file:" + fs::absolute(side->file, error).string()});
  }
  command.add({"-lavfi", graph(labels, film)});
  if (film)
    command.add({"-c:v", "libx264", "-preset", "medium", "-crf", "16", "-color_range", "tv", "-colorspace",
                 "bt709", "-color_primaries", "bt709", "-f", "mp4"});
  else
    command.add({"-frames:v", "1", "-update", "1", "-c:v", "png", "-f", "image2"});
  command.add({"file:" + part.string()});
  Result<int> code = run(command);
  if (!code || *code != 0) {
    fs::remove(part, error);
    std::string why = tells_full_disk(said.text()) ? "no room on the disk" : said.text();
    return {{"", out.string() + " could not be made: " + why}};
  }
  return put_in_place(part, out);
}

MeasuredFilm film_of(const Side& side) {
  std::string size = side.size;
  size[size.find(',')] = 'x';
  return {side.file, size_of(size), side.rate};
}

/// The films or pictures that two paths stand for, of one kind and one size, into `sides`; else what is
/// wrong.
ExitCode find_sides(const CompareArguments& arguments, Side (&sides)[2], Errors& errors) {
  for (std::size_t i = 0; i < 2; ++i) {
    Result<fs::path> file = found(i == 0 ? arguments.a : arguments.b);
    if (!file) return errors = file.errors(), kWrongInput;
    sides[i].file = *file;
  }
  const auto& [a, b] = sides;
  auto wrong = [&](const std::string& what) { return errors = {{"", what}}, kWrongInput; };
  if (a.picture() != b.picture())
    return wrong(a.file.string() + " and " + b.file.string() + ": expected two films or two pictures");
  std::string ending = a.picture() ? ".png" : ".mp4";
  if (arguments.out && fs::path(*arguments.out).extension() != ending)
    return wrong(*arguments.out + ": expected a name that ends in " + ending);
  for (Side& side : sides)
    if (errors = describe(side); !errors.empty()) return kCouldNot;
  if (a.size != b.size)
    return wrong(fmt::format("{} is of {} pixels, {} of {}; expected one size", a.file.string(), a.size,
                             b.file.string(), b.size));
  return kDone;
}

/// Shows them side by side in a file, which it names.
void show_sides(const CompareArguments& arguments, const Side& a, const Side& b) {
  fs::path out = arguments.out.value_or(a.picture() ? "out/compare.png" : "out/compare.mp4");
  std::error_code error;
  out = fs::absolute(out, error).lexically_normal();
  fs::create_directories(out.parent_path(), error);
  if (error) fail_run({{"", out.string() + ": its folder cannot be made"}}, kCouldNot);
  or_fail_run(make_comparison(a, b, out), kCouldNot);
  if (!arguments.json) put(out.string() + "\n");
}

}  // namespace

void compare(const CompareArguments& arguments) {
  fs::path frames[2];
  if (is_folder(arguments.a) && is_folder(arguments.b))
    for (std::size_t i = 0; i < 2; ++i) frames[i] = folder_of_frames(i == 0 ? arguments.a : arguments.b);
  bool of_frames = !frames[0].empty() && !frames[1].empty();
  Side sides[2];
  Errors errors;
  ExitCode code = find_sides(arguments, sides, errors);
  // Two folders that hold frames alone are compared by figures, as long as nobody asks to see the frames.
  bool shown = code == kDone && (arguments.out || !arguments.json);
  if (code != kDone && (!of_frames || arguments.out)) fail_run(errors, code);
  const auto& [a, b] = sides;
  Measured measured = of_frames     ? measure_frames(frames[0], frames[1])
                      : a.picture() ? measure_pictures(a.file, b.file)
                                    : measure_films(film_of(a), film_of(b));
  if (!measured.errors.empty()) fail_run(measured.errors, measured.code);
  if (shown) show_sides(arguments, a, b);
  if (arguments.json)
    put(figures_as_json(measured));
  else
    say(figures_in_words(measured));
  if (!arguments.json) tell_notes(errors);  // why nothing is shown of what was measured
}

}  // namespace frond
