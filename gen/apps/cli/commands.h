#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "farm/hand_over.h"
#include "images/tone.h"

namespace frond {

/// Exit codes of the program.
enum ExitCode {
  kDone = 0,
  kCouldNot = 1,
  kWrongInput = 2,
  kNoLandlock = 3,
  kNothingGrown = 4,
  kInterrupted = 130,
  kStopped = 143
};

/// What the command line says about a preset.
struct PresetArguments {
  std::string path;
  std::vector<std::string> sets;       ///< `/json/pointer=value`
  std::optional<std::string> size;     ///< WxH
  std::optional<double> scale;         ///< multiplies the size, 1..16
  std::optional<std::string> quality;  ///< draft, good or best
  std::optional<double> fps;           ///< frames a second
  std::optional<double> seconds;       ///< how long the film is
  std::optional<std::string> assets;   ///< the only folder to read from besides the preset's own
  std::optional<std::string> print;    ///< size on paper: 20cm, 20x15cm, 8in
  std::optional<double> dpi;           ///< pixels an inch
  std::optional<std::string> crop;     ///< X,Y,WxH: the part that is drawn
  std::optional<int> depth;            ///< bits of a channel, 8 or 16
  bool transparent = false;            ///< as film.background
};

struct GenerateArguments {
  PresetArguments preset;
  std::string out;                    ///< folder; empty: out/<preset name>
  std::optional<std::string> frames;  ///< A-B
  int threads = 0;                    ///< 0: all
  std::optional<bool> resolve;        ///< whether frames are resolved; none: in the quality good
  bool alone = false;                 ///< none of the frames around, with which raw ones are resolved
  bool film_only = false;             ///< no frames, only what makes a film of finished pictures
  bool quiet = false;
};

struct LookArguments {
  PresetArguments preset;
  std::string out;     ///< PNG file; empty: <preset name>_look.png, of views _views.png
  int frame = 0;       ///< 0: the last
  bool views = false;  ///< six compositions in place of the preset's camera
};

struct InfoArguments {
  PresetArguments preset;             ///< or a grammar
  std::optional<std::string> frames;  ///< A-B
  bool json = false;                  ///< for machines
  bool sizes = false;                 ///< grows it and says how large all is
  int frame = 0;                      ///< that sizes are of, which it asks for; 0: the last
};

struct PassesArguments {
  PresetArguments preset;
  std::string out;                    ///< folder; empty: out/<preset name>/passes
  std::optional<std::string> frames;  ///< A-B; none: the last
  int threads = 0;                    ///< 0: all
  int side = 4;                       ///< side * side rays tell the shares of a pixel
  bool albedo = false;                ///< also the colours of surfaces, by POV-Ray
  bool views = false;                 ///< also PNG pictures to look at
};

struct ResolveArguments {
  PresetArguments preset;
  std::string folder;                 ///< of the raw film; empty: out/<preset name>
  std::string out;                    ///< folder to write to; empty: frames in that
  std::optional<std::string> frames;  ///< A-B
  int threads = 0;                    ///< 0: all
  int window = 4;                     ///< see ResolveOptions
  std::optional<int> side;
  double reach = 0.4;
  std::optional<double> fade, clip;
  bool quiet = false;
};

struct DrawArguments {
  PresetArguments preset;
  std::string out;                    ///< folder; empty: out/<preset name>/drawn
  std::optional<std::string> frames;  ///< A-B; none: the last
  double pen = 1;                     ///< width of lines, relative to the usual
  double hatch = 4.5;                 ///< lines' widths between lines of hatching; 0: none
  int threads = 0;                    ///< 0: all
};

struct DevelopArguments {
  std::vector<std::string> pictures;  ///< PNG files, of one size
  std::string out;                    ///< a PNG file
  Tone tone;
  int depth = 8;  ///< bits of a channel of it
};

struct ExportArguments {
  PresetArguments preset;
  std::string out;                    ///< file to write; its extension says the format
  int frame = 0;                      ///< 0: the last
  std::optional<std::string> frames;  ///< A-B: those that an include or a .glb holds
  int keys = 12;                      ///< how many shapes those of a .glb go through, at most
  int levels = 1;                     ///< of detail, of a .glb
  int seeds = 1;                      ///< how many shapes an include holds
  int sides = 10;                     ///< of the tubes that branches become
  double voxel = 0;                   ///< metres, of a volume; 0: as the organisms' bodies have it
  std::string detail =
      "250000";            ///< triangles of one organism, about, or as it is seen so many pixels high: 400px
  int texture = 512;       ///< pixels, the width of a picture; 0: none
  bool instances = false;  ///< organs and bodies once each, with their placements
  bool quiet = false;
};

struct GrammarArguments {
  std::string path;                    ///< a grammar, or a preset with one
  std::optional<double> steps;         ///< instead of the grammar's own; whole ones only for a word
  std::optional<std::uint64_t> seed;   ///< the same
  std::optional<double> angle;         ///< degrees, of turns without a parameter
  int mutations = 0;                   ///< of a grammar of LParser
  std::string system = {};             ///< which of several L-systems in a file of Fractint
  std::string format = "text";         ///< of the word; counts: how often each symbol occurs, instead
  std::optional<std::string> picture;  ///< SVG file to write: the derivation tree, or what the turtle draws
  std::optional<std::string> assets;   ///< as of a preset
};

struct PlanArguments {
  PresetArguments preset;
  std::string out;  ///< SVG file; empty: <preset name>_plan.svg
  int seeds = 1;    ///< how many plans, side by side
};

struct StandArguments {
  PresetArguments preset;
  std::string out;   ///< SVG, or CSV by its name; empty: <preset name>_stand.svg
  double year = -1;  ///< of the map and of the distributions; negative: the last one
};

struct TextureArguments {
  PresetArguments preset;  ///< its path may be empty: every bark and leaf that there is
  std::string out;         ///< folder; empty: out/textures
  int threads = 0;         ///< 0: all
  bool quiet = false;
};

struct FarmArguments {
  PresetArguments preset;
  FarmOrder order;                                    ///< without what is said by the others
  std::string out;                                    ///< folder; empty: out/<preset name>
  std::string chunk = "4", bands = "8";               ///< frames a task; tasks of a still
  std::optional<std::string> site;                    ///< JSON file
  bool status = false, cancel = false, logs = false;  ///< instead, of what was handed over
};

struct ConfineArguments {
  std::vector<std::string> read;   ///< files and folders
  std::vector<std::string> write;  ///< folders
  std::vector<std::string> words;  ///< the program and its arguments
};

struct FrameArguments {
  std::string scene;               ///< a .pov
  std::string picture;             ///< a .png
  std::string size;                ///< WIDTHxHEIGHT
  std::vector<std::string> flags;  ///< of POV-Ray
};

struct FilmArguments {
  std::string list;              ///< a file that names the pictures, one a line
  std::string file;              ///< to write: a film; a sheet where there are columns; a still
  std::string fps = "24";        ///< frames a second
  std::string title, comment;    ///< for a film's metadata
  int columns = 0, width = 240;  ///< of a sheet, and of its pictures at most
  bool alpha = false;            ///< keeps the opacity of pictures in a film
  double dpi = 0;                ///< that a copy of one picture says; 0: none
};

struct RenderArguments {
  PresetArguments preset;
  std::string out;                    ///< folder; empty: out/<preset name>
  std::optional<std::string> frames;  ///< A-B
  std::string format;                 ///< of the film: one of kFilmFormats; empty: mp4, or mov with opacity
  int jobs = 0;                       ///< processors that render; 0: all
  int threads = 0;                    ///< that generate; 0: all
  int every = 1;                      ///< each K-th frame first, then those between
  bool watch = false;                 ///< shows what is traced in a picture
  int why = 0;                        ///< renders nothing and says why this frame is out of date
  std::optional<bool> resolve;        ///< whether frames are resolved; none: in the quality good
  std::optional<std::string> plot;    ///< SVG file to write
  std::vector<std::string> compare;   ///< A, B and perhaps a file: compares them instead
  std::vector<std::string> sweeps;    ///< POINTER=FROM:TO:COUNT: makes a sheet instead
  std::optional<std::string> seeds;   ///< how many: a sheet over them
};

struct CompareArguments {
  std::string a, b;                ///< pictures, films, or folders of runs or of frames
  std::optional<std::string> out;  ///< file to write, which shows them side by side
  bool json = false;               ///< figures for machines, and no file that is not asked for
};

struct TaskArguments {
  std::string folder;              ///< of the farm's job
  int cpus = 1;                    ///< processors to use; 0: all
  std::string work;                ///< frames, bands or film
  std::vector<std::string> words;  ///< what it is told besides
};

struct GalleryArguments {
  std::string out = "out/gallery";  ///< folder of what pictures are made of
  bool large = false;               ///< the best of them, large
  bool stale = false;               ///< renders nothing, and names those that do not show what is there now
  std::vector<std::string> names;   ///< of pictures; none: all
};

struct DescribeArguments {
  std::vector<std::string> words;  ///< that are asked for; none: what there is
  bool json = false;               ///< for machines
};

struct NewArguments {
  std::string name;               ///< of the file to write, with or without its .json
  std::string from;               ///< a kind, the file of a preset, or the name of one that is shipped
  std::vector<std::string> with;  ///< species of a bed, in place of `from`
  std::string program = "frond";  ///< as it was called, for what is said to come next
  bool quiet = false;
};

struct ImportArguments {
  std::string path;                   ///< of a model of cpfg, or a grammar of LParser or Houdini
  std::string out;                    ///< the preset to write; empty: beside the file, with its name
  std::optional<int> steps;           ///< none: as many as the file says
  std::optional<std::uint64_t> seed;  ///< instead of the grammar's
  int mutations = 0;                  ///< of a grammar of LParser
  std::string system = {};            ///< which of several L-systems in a file of Fractint
  bool z_up = false;                  ///< of a skeleton: its z is up
};

struct StudioArguments {
  std::string preset;                 ///< may be empty: the gallery
  int port = 0;                       ///< 0: the usual, or any that is free
  bool open = false;                  ///< in the desktop's browser
  std::size_t memory = 1024;          ///< MB that the studio keeps
  std::optional<std::string> assets;  ///< as of a preset
};

/// Each is one command of the program, and throws a CommandEnd where it comes to none. Data goes to stdout,
/// messages to stderr.
void generate(const GenerateArguments& arguments);
void write_textures(const TextureArguments& arguments);
void look(const LookArguments& arguments);
void resolve(const ResolveArguments& arguments);
void passes(const PassesArguments& arguments);
void draw_ink(const DrawArguments& arguments);
void develop_picture(const DevelopArguments& arguments);
void export_scene(const ExportArguments& arguments);
void export_include(const ExportArguments& arguments);
void info(const InfoArguments& arguments);
void list_files(const PresetArguments& arguments);
void farm(const FarmArguments& arguments);
void info_grammar(const std::string& path, const std::optional<std::string>& assets, bool json);
/// Checks a grammar; says that it is one, and what it is for.
void check_grammar(const PresetArguments& arguments);
void derive_word(const GrammarArguments& arguments);
void walk_turtle(const GrammarArguments& arguments);
void draw_plans(const PlanArguments& arguments);
void draw_stand(const StandArguments& arguments);
void list_everything(bool json);
void print_schema();
void describe_properties(const DescribeArguments& arguments);
void new_preset(const NewArguments& arguments);
void import_model(const ImportArguments& arguments);
void studio(const StudioArguments& arguments);
void frame(const FrameArguments& arguments);
void film(const FilmArguments& arguments);
void render(const RenderArguments& arguments);
void sheet(const RenderArguments& arguments);
void farm_task(const TaskArguments& arguments);
void gallery(const GalleryArguments& arguments);
void compare(const CompareArguments& arguments);
/// Returns only where the program could not be started.
void run_confined(const ConfineArguments& arguments);

}  // namespace frond
