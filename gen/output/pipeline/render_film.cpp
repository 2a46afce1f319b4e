#include "pipeline/render_film.h"

#include <fmt/format.h>

#include "pipeline/frame_times.h"
#include "pipeline/out_folder.h"
#include "pipeline/pace.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// A program that is named by its path is given by one that holds in any folder.
std::string variable(const char* name, const std::string& program) {
  std::error_code error;
  bool path = program.find('/') != program.npos;
  return fmt::format("{}={}", name, path ? fs::absolute(program, error).string() : program);
}

}  // namespace

RenderPrograms RenderPrograms::usual() {
  return {environment_or("FROND_POVRAY", "povray"), environment_or("FROND_FFMPEG", "ffmpeg")};
}

Errors RenderPrograms::missing(bool film) const {
  if (!find_program(povray)) return {{"", povray + ": no such program; it is what renders"}};
  if (film && !find_program(ffmpeg))
    return {{"", ffmpeg + ": no such program; it is what makes films of frames"}};
  return {};
}

std::vector<std::string> RenderPrograms::environment(const fs::path& home) const {
  std::error_code error;
  return {"FROND_HOME=" + fs::absolute(home, error).string(), variable("FROND_POVRAY", povray),
          variable("FROND_FFMPEG", ffmpeg)};
}

RenderedFilm render_written(const RenderSettings& settings, const fs::path& home, const fs::path& preset,
                            Stop& stop, RunEvents& events) {
  std::size_t noted = read_times(settings.out).size();
  RenderRun run(settings, RenderPrograms::usual().environment(home), stop, events);
  RenderedFilm made{run.run(), {}};
  if (!made.outcome.well()) return made;
  note_times(settings.out, noted, run.manifest(), run.rendered(), preset, events);
  for (const std::string& result : run.results()) made.results.push_back(settings.out / result);
  return made;
}

RenderedFilm render_film(const FilmFolder& film, RenderSettings settings, Stop& stop, RunEvents& events) {
  RenderPrograms programs = RenderPrograms::usual();
  if (Errors errors = programs.missing(film.preset.film.frames > 1); !errors.empty()) return {{errors}, {}};
  if (Errors errors = refuse_folder(film.out); !errors.empty()) return {{errors}, {}};
  RunLock lock(film.out, events);
  if (!lock.errors().empty()) return {{lock.errors()}, {}};
  measure_machine(programs.povray);
  if (Outcome written = write_film(film, events); !written.well()) return {std::move(written), {}};
  settings.ffmpeg = programs.ffmpeg;
  return render_written(settings, film.home, film.file, stop, events);
}

}  // namespace frond
