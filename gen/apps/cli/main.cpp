// The command line of Frond. Each command is one function in commands.h.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <new>
#include <stdexcept>

#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/named.h"
#include "cli/rendering.h"
#include "cli/streams.h"
#include "cli/words.h"

using namespace frond;

namespace {

// Each command below owns its arguments, which live as long as its callback does.

void add_generate(CLI::App& app) {
  auto [command, to] =
      add_command(app, "generate", "Writes the frames of a film, manifest.json and build.ninja", generate);
  add_preset(command, to->preset);
  add_pictures(command, to->preset);
  command->add_option("-o,--out", to->out, "Folder to write to (out/<preset name>)");
  command->add_option("--frames", to->frames, "A-B: only these frames");
  add_resolving(command, to->resolve);
  command->add_flag("--alone", to->alone, "None of the frames around, with which others are resolved");
  command->add_flag("--film-only", to->film_only,
                    "No frames: only build.ninja, which makes a film of pictures rendered elsewhere");
  command->add_option("--threads", to->threads, "How many threads (all)")->check(CLI::Range(0, 1024));
  command->add_flag("-q,--quiet", to->quiet, "No progress");
  command->footer(R"(Example:
  frond generate presets/reef.json -o out/reef --frames 1-24 --set /seed=8)");
}

void add_textures(CLI::App& app) {
  auto [command, to] = add_command(
      app, "textures", "Writes bark and leaves of a preset's trees as PNG pictures", write_textures);
  add_preset(command, to->preset);
  command->get_option("preset")->required(false)->description("The preset; without it, every kind there is");
  command->add_option("-o,--out", to->out, "Folder to write to (out/textures)");
  command->add_option("--threads", to->threads, "How many threads (all)")->check(CLI::Range(0, 1024));
  command->add_flag("-q,--quiet", to->quiet, "Does not list the files");
  command->footer(R"(Example:
  frond textures presets/aspen.json -o out/textures)");
}

void add_resolve(CLI::App& app) {
  auto [command, to] = add_command(
      app, "resolve", "Makes the frames of a film of raw ones, which `frond generate --resolve` has rendered",
      resolve);
  add_preset(command, to->preset);
  add_pictures(command, to->preset);
  command->add_option("--film", to->folder,
                      "Folder of the film, with its raw frames in raw/ (out/<preset name>)");
  command->add_option("-o,--out", to->out, "Folder to write to (frames/ in that)");
  command->add_option("--frames", to->frames, "A-B: only these frames");
  command->add_option("--threads", to->threads, "How many threads (all)")->check(CLI::Range(0, 1024));
  command->add_option("--window", to->window, "Raw frames before and after one that it is made of (4)")
      ->check(CLI::Range(0, 12));
  command->add_option("--side", to->side, "N: N * N rays are traced through a pixel (5; 6 of a still)")
      ->check(CLI::Range(1, 16));
  command->add_option("--reach", to->reach, "Pixels within which samples count (0.4)")
      ->check(CLI::Range(0.1, 3.0));
  command
      ->add_option("--fade", to->fade,
                   "Frames within which samples count (4; 0.1 s where waves move the light)")
      ->check(CLI::Range(0.1, 100.0));
  command
      ->add_option("--clip", to->clip,
                   "Deviations by which the light of other frames may differ; 0: any (0; 2 where waves move "
                   "the light)")
      ->check(CLI::Range(0.0, 100.0));
  command->add_flag("-q,--quiet", to->quiet, "No words where all goes well");
  command->footer(R"(Example:
  frond resolve presets/reef.json --film out/reef --frames 1-24)");
}

void add_passes(CLI::App& app) {
  auto [command, to] = add_command(
      app, "passes",
      "Depth, normals, places, motion, sunlight and masks of all that stands there, as OpenEXR", passes);
  add_preset(command, to->preset);
  add_size(command, to->preset);
  command->add_option("-o,--out", to->out, "Folder to write to (out/<preset name>/passes)");
  command->add_option("--frames", to->frames, "A-B: only these frames (the last)");
  command->add_option("--side", to->side, "N: N * N rays tell the shares of a pixel (4)")
      ->check(CLI::Range(1, 16));
  command->add_option("--threads", to->threads, "How many threads (all)")->check(CLI::Range(0, 1024));
  command->add_flag("--albedo", to->albedo, "Also the colours of surfaces without light, by POV-Ray");
  command->add_flag("--views", to->views,
                    "Also PNG pictures to look at: depth, normal, sun, parts, motion, albedo");
  command->footer(R"(Example:
  frond passes presets/reef.json --frames 1-24 -o passes)");
}

void add_look(CLI::App& app) {
  auto [command, to] = add_command(
      app, "look",
      "Draws at once, without a renderer, what the camera sees, and says how large all has grown", look);
  add_preset(command, to->preset);
  add_size(command, to->preset);
  command->add_option("-o,--out", to->out, "FILE.png (<preset name>_look.png, of views _views.png)");
  command->add_option("--frame", to->frame, "Which frame (the last)")->check(CLI::Range(1, 1'000'000));
  command->add_flag("--views", to->views,
                    "A sheet of six composed views instead, and the property that chooses each");
  command->footer(R"(Example:
  frond look presets/garden/palm.json -o palm.png --set '/scene/camera/fit=["all"]')");
}

void add_develop(CLI::App& app) {
  auto [command, to] = add_command(
      app, "develop",
      "Gives a picture of 16 bits a channel, or the mean light of several, the tone that its scene names",
      develop_picture);
  command->add_option("pictures", to->pictures, "The PNG files that POV-Ray wrote, with +FN16")->required();
  command->add_option("-o,--out", to->out, "FILE.png")->required();
  command->add_option("--highlights", to->tone.highlights, "Stops above white that keep their shape (0)")
      ->check(CLI::Range(0.0, 6.0));
  command->add_option("--contrast", to->tone.contrast, "How steep the curve is at middle grey (1)")
      ->check(CLI::Range(0.5, 2.0));
  command->add_option("--saturation", to->tone.saturation, "Factor of how colourful it is (1)")
      ->check(CLI::Range(0.0, 2.0));
  command->add_option("--warmth", to->tone.warmth, "Share of red that white gains and black loses (0)")
      ->check(CLI::Range(-0.5, 0.5));
  command->add_option("--vignette", to->tone.vignette, "Share of their light that the corners lose (0)")
      ->check(CLI::Range(0.0, 1.0));
  command->add_option("--depth", to->depth, "8 or 16 bits a channel (8)")->check(CLI::IsMember({8, 16}));
  command->footer(R"(Example:
  frond develop frame_0001.png -o birch.png --highlights 2 --contrast 1.1)");
}

void add_export(CLI::App& app) {
  auto [command, to] = add_command(
      app, "export", "Writes what grows, at one frame, for other programs or your own POV-Ray scene",
      export_scene);
  add_preset(command, to->preset);
  command->add_option("--frame", to->frame, "Which frame (the last)")->check(CLI::Range(1, 1'000'000));
  command->add_option("--frames", to->frames,
                      "A-B: of an .inc, frames whose shapes it holds; of a .glb, an animation of them");
  command->add_option("--keys", to->keys, "Of --frames of a .glb: through how many shapes it goes (12)")
      ->check(CLI::Range(2, 1000));
  command->add_option("--seeds", to->seeds, "Of an .inc: how many shapes, each of a seed of its own (1)")
      ->check(CLI::Range(1, 100));
  command->add_option("-o,--out", to->out, "FILE.obj, FILE.ply, FILE.glb, FILE.vdb or FILE.inc")->required();
  command->add_option("--sides", to->sides, "Of the tubes that branches become (10)")
      ->check(CLI::Range(3, 256));
  command->add_option("--voxel", to->voxel, "Metres, of a .vdb (as the organisms' bodies have it)")
      ->check(CLI::PositiveNumber);
  command->add_option(
      "--detail", to->detail,
      "Triangles of one organism or model, about (250000), or as fine as it is seen so many pixels "
      "high: 400px");
  command
      ->add_option(
          "--lods", to->levels,
          "Of a .glb: how many levels of detail, each of a quarter of the triangles of the one before (1)")
      ->check(CLI::Range(1, 6));
  command->add_option("--texture", to->texture, "Pixels, the width of pictures; 0: none (512)")
      ->check(CLI::Range(0, 4096));
  command->add_flag("--instances", to->instances, "Each organ and copy once, with its places (of a .glb)");
  command->add_flag("-q,--quiet", to->quiet, "No words where all goes well");
  command->footer(R"(Examples:
  frond export presets/reef.json --frame 48 -o reef.glb
  frond export presets/trees/oak.json --seeds 3 -o oak.inc)");
}

void add_info(CLI::App& app) {
  auto [command, to] =
      add_command(app, "info", "Estimates how large a preset's scene or a grammar's word will be", info);
  add_preset(command, to->preset);
  add_size(command, to->preset);
  command->add_option("--frames", to->frames, "A-B: of a film only these frames");
  command->add_flag("--json", to->json, "For machines");
  command->add_flag("--sizes", to->sizes,
                    "Grows it and says how high and wide each organism has become, and its stem");
  command->add_option("--frame", to->frame, "Of --sizes: in which frame (the last)")
      ->check(CLI::Range(1, 1'000'000));
  command->footer(R"(Examples:
  frond info presets/reef.json --json
  frond info presets/trees/oak.json --sizes
  frond info presets/garden/grammar_palm.json --sizes --frame 60)");
}

void add_files(CLI::App& app) {
  auto [command, preset] = add_command(
      app, "files", "Names all files that a preset is read from, each ended by a zero byte", list_files);
  add_preset(command, *preset);
  command->footer(R"(Example:
  frond files presets/ivy/any_mesh.json | xargs -0 tar cf any_mesh.tar)");
}

void add_derive(CLI::App& app) {
  auto [command, to] = add_command(app, "derive", "Derives the word of a grammar", derive_word);
  add_grammar(command, *to)->check(CLI::TypeValidator<int>());
  command->add_option("--format", to->format, "text or counts")->check(CLI::IsMember({"text", "counts"}));
  command->add_option("--tree", to->picture, "SVG file: which symbol came from which");
  command->footer(R"(Example:
  frond derive koch.json --steps 2 --tree koch.svg)");
}

void add_turtle(CLI::App& app) {
  auto [command, to] =
      add_command(app, "turtle", "Walks a grammar's word and measures the way, as JSON", walk_turtle);
  add_grammar(command, *to);
  command->add_option("--svg", to->picture, "SVG file: what the turtle draws, seen from the front");
  command->footer(R"(A number of steps that is not whole gives the shape on its way from one to the next.
Example:
  frond turtle koch.json --steps 2.5 --svg koch.svg)");
}

void add_plan(CLI::App& app) {
  auto [command, to] =
      add_command(app, "plan", "Draws the plan of a preset that has one, as SVG", draw_plans);
  add_preset(command, to->preset);
  command->add_option("-o,--out", to->out, "FILE.svg (<preset name>_plan.svg)");
  command->add_option("--seeds", to->seeds, "N: the plans of that many seeds, from the preset's on (1)")
      ->check(CLI::Range(1, 100));
  command->footer(R"(Example:
  frond plan presets/garden/walled.json --seeds 4 -o plans.svg)");
}

void add_stand(CLI::App& app) {
  auto [command, to] = add_command(
      app, "stand", "Simulates the stand or the reef of a preset, and plots it as SVG or CSV", draw_stand);
  add_preset(command, to->preset);
  command->add_option("-o,--out", to->out, "FILE.svg or FILE.csv (<preset name>_stand.svg or _reef.svg)");
  command->add_option("--year", to->year, "N: the year of the map and the distributions (the last)")
      ->check(CLI::NonNegativeNumber);
  command->footer(R"(Examples:
  frond stand presets/forest/clearing.json --year 120 -o stand.svg
  frond stand presets/reef/century.json -o reef.csv)");
}

void add_catalogue(CLI::App& app) {
  app.add_subcommand("schema", "Prints the JSON Schema of presets")->callback(print_schema);
  auto [command, json] = add_command(
      app, "list", "Lists growers, settings, presets, species and turtle symbols", list_everything);
  command->add_flag("--json", *json, "For machines");
}

void add_describe(CLI::App& app) {
  auto [command, to] = add_command(
      app, "describe", "Says what a property of presets does, by its name or by a word", describe_properties);
  command->add_option("what", to->words,
                      "A kind, a setting, a property as in tree/habit, or words; none: what there is");
  command->add_flag("--json", to->json, "For machines");
  command->footer(R"(Examples:
  frond describe tree/habit
  frond describe leaf size)");
}

void add_new(CLI::App& app) {
  auto [command, to] = add_command(
      app, "new", "Writes a commented preset to begin with", +[](const NewArguments& given) {
        if (given.from.empty() && given.with.empty()) throw CLI::RequiredError("--from or --with");
        new_preset(given);
      });
  to->program = app.get_name();
  command->add_option("name", to->name, "The file to write; .json is added where it is missing")->required();
  command->add_option("--from", to->from, "A kind, as tree, or a preset, as presets/trees/oak.json or oak")
      ->excludes(command
                     ->add_option("--with", to->with,
                                  "Species of a bed that is laid out by their sizes, as rose,lavender,apple")
                     ->delimiter(','));
  command->add_flag("-q,--quiet", to->quiet, "Does not say what comes next");
  command->footer(R"(Examples:
  frond new my_tree --from tree
  frond new my_reef --from presets/reef.json
  frond new my_garden --with rose,lavender,apple)");
}

void add_import(CLI::App& app) {
  auto [command, to] =
      add_command(app, "import", "Writes a preset of another program's grammar, which renders", import_model);
  command
      ->add_option("grammar", to->path,
                   "A model of cpfg (.l), a grammar of LParser (.ls), Houdini (.txt) or Fractint, or a "
                   "skeleton (.swc)")
      ->required();
  command->add_option("-o,--out", to->out, "FILE.json (beside the grammar, with its name)");
  command->add_option("--steps", to->steps, "N: derivation steps (as the file says)")
      ->check(CLI::Range(0, 1'000'000));
  command->add_option("--seed", to->seed, "For random choices, instead of the grammar's");
  add_mutations(command, to->mutations);
  add_system(command, to->system);
  command->add_flag("--z-up", to->z_up, "Of a skeleton: its z is up, not its y");
  command->footer(R"(Example:
  frond import plants/rose.l -o rose.json)");
}

void add_studio(CLI::App& app) {
  auto [command, to] =
      add_command(app, "studio", "Serves a page in the browser: sliders, a live view, stills", studio);
  command->add_option("preset", to->preset, "The preset to open, a JSON file or a name; none: the gallery")
      ->transform(named_by(&preset_named));
  command->add_option("--port", to->port, "Of the address (8417, or any that is free)")
      ->check(CLI::Range(1, 65535));
  command->add_flag("--open", to->open, "Opens the page in the desktop's browser");
  command
      ->add_option("--memory", to->memory,
                   "MB that scenes and what else is kept may take together (1024); growing takes more")
      ->check(CLI::Range(16, 1 << 20));
  add_assets(command, to->assets);
  command->footer(R"(Example:
  frond studio presets/reef.json --open)");
}

int run(int count, char** words) {
  std::vector<std::string> list = words_of(count, words);
  CLI::App app{"Grows plants and corals from JSON presets and writes scenes that POV-Ray films.",
               list.empty() ? "frond" : list[0]};
  app.require_subcommand(0, 1);
  app.set_version_flag("--version", versions, "The versions of Frond, of its libraries and of POV-Ray");
  app.footer(
      "FROND_HOME is the folder that holds templates/, povinc/ and presets/, where that is not the one that "
      "the program was built in or is installed with.");
  for (auto add : {add_new,    add_describe, add_catalogue, add_check,   add_import,  add_studio,  add_try,
                   add_look,   add_info,     add_draw,      add_plan,    add_stand,   add_derive,  add_turtle,
                   add_render, add_sheet,    add_generate,  add_resolve, add_film,    add_compare, add_export,
                   add_passes, add_textures, add_farm,      add_files,   add_develop, add_confine, add_frame,
                   add_task,   add_gallery,  add_completion})
    add(app);
  group_commands(app);
  judge_options(app);
  if (std::string wrong = unknown_command(app, count > 1 ? words[1] : ""); !wrong.empty()) {
    tell(wrong);
    return kWrongInput;
  }
  if (count < 2) {
    put(first_words(count > 0 ? words[0] : "frond"));
    return kDone;
  }
  try {
    std::vector<const char*> named;
    for (const std::string& word : list) named.push_back(word.c_str());
    app.parse(count, named.data());
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::string wrong = unknown_option(app, list);
    tell(wrong.empty() ? error.what() : wrong);
    tell("Run with --help for more information.");
    return kWrongInput;
  } catch (const CommandEnd& end) {
    return end.code;
  }
  return kDone;
}

}  // namespace

int main(int count, char** words) {
  open_streams();
  int result = kCouldNot;
  // No library is believed not to throw, nor memory not to run out: here is the last place to say so.
  try {
    result = run(count, words);
  } catch (const std::bad_alloc&) {
    result = fail_for_memory();
  } catch (const std::length_error&) {
    result = fail_for_memory();
  } catch (const std::exception& error) {
    tell(fmt::format("frond: failed while {}: {}", what_is_done(), error.what()));
  }
  Errors lost = close_out();
  if (lost.empty()) return result;
  tell_errors(lost);
  return result == kDone ? kCouldNot : result;
}
