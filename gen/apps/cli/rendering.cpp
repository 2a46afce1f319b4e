#include "cli/rendering.h"

#include "cli/commands.h"

namespace frond {

namespace {

/// What a run is told, whatever it makes.
void add_run(CLI::App* command, RenderArguments& to) {
  command->add_option("-o,--out", to.out, "DIR: where to (out/<preset name>)");
  command->add_option("--frames", to.frames, "A-B: only these frames");
  command
      ->add_option("--jobs", to.jobs,
                   "How many processors render (all): frames at once, or parts of a picture")
      ->check(CLI::Range(1, 9999));
  command->add_option("--threads", to.threads, "How many threads generate the scenes (all)")
      ->check(CLI::Range(0, 1024));
}

void add_sweeps(CLI::App* command, RenderArguments& to) {
  command
      ->add_option("--sweep", to.sweeps,
                   "POINTER=FROM:TO:COUNT: a sheet over a value of the preset; may be given again")
      ->allow_extra_args(false);
  command->add_option("--contact-seeds", to.seeds, "N: a sheet over the seeds from 1 to N");
}

}  // namespace

void add_confine(CLI::App& app) {
  auto [command, to] = add_command(
      app, "confine", "Runs a program that can open nothing but what is below the paths that are named",
      run_confined);
  command->add_option("--read", to->read, "PATH: a file or a folder that it may read; may be given again")
      ->allow_extra_args(false);
  command->add_option("--write", to->write, "FOLDER: that it may write to, too; may be given again")
      ->allow_extra_args(false);
  command->add_option("program", to->words, "The program and its arguments, behind --")->required();
  command->footer(
      R"(The system's own programs and libraries (/usr) can be read, too. Exit code 3: the kernel has no
Landlock (Linux 5.13).

Example:
  frond confine --read scene --write pictures -- povray +Iscene/a.pov)");
}

void add_draw(CLI::App& app) {
  auto [command, to] = add_command(
      app, "draw", "Draws what grows in ink, with outlines and hatching, without POV-Ray", draw_ink);
  add_preset(command, to->preset);
  add_size(command, to->preset);
  add_print(command, to->preset);
  command->add_option("-o,--out", to->out, "Folder to write to (out/<preset name>/drawn)");
  command->add_option("--frames", to->frames, "A-B: only these frames (the last)");
  command->add_option("--pen", to->pen, "N: lines so many times as wide as usual (1)")
      ->check(CLI::Range(0.2, 10.0));
  command
      ->add_option("--hatch", to->hatch, "N: lines' widths between lines of hatching; 0 leaves it out (4.5)")
      ->check(CLI::Range(0.0, 50.0));
  command->add_option("--threads", to->threads, "How many threads (all)")->check(CLI::Range(0, 1024));
  command->footer(
      R"(The paper is white; with --transparent only the ink is there. --size or --print says how large it is.

Example:
  frond draw presets/garden/palm.json --print 12cm -o palm)");
}

void add_frame(CLI::App& app) {
  auto [command, to] = add_command(
      app, "frame",
      "Renders one frame by POV-Ray; called by ninja in the folder of the film, with which it ends", frame);
  command->add_option("scene", to->scene, "SCENE.pov")->required();
  command->add_option("picture", to->picture, "PICTURE.png, to write")->required();
  command->add_option("size", to->size, "WIDTHxHEIGHT")->required();
  command->add_option("flags", to->flags, "Further flags of POV-Ray, behind --");
  command->footer(
      R"(Killed and called again it goes on within the picture. Adds a line to .times in the folder above the
picture's: the frame, milliseconds of processor that it took, and its size.

FROND_THREADS is how many threads trace it (1), FROND_POVRAY names another povray, and
FROND_UNCONFINED=1 lets it open any file that you may open.

Example:
  frond frame frames/frame_0001.pov frames/frame_0001.png 640x360 -- +A0.0 +AM1 +R3 -J)");
}

void add_film(CLI::App& app) {
  auto [command, to] = add_command(
      app, "film", "Makes a film of finished pictures, or with --columns a sheet of them, by ffmpeg", film);
  command->add_option("list", to->list, "A file that names PNG pictures, one a line")->required();
  command
      ->add_option("file", to->file,
                   "FILM.mp4, FILM.webm, FILM.gif, FILM.webp or FILM.mov (ProRes 4444); a sheet, or a copy "
                   "of one picture, is a FILE.png")
      ->required();
  command->add_option("--fps", to->fps, "Frames a second (24)");
  command->add_option("--title", to->title, "For the film's metadata, of a GIF for a comment");
  command->add_option("--comment", to->comment, "The same");
  command->add_flag("--alpha", to->alpha, "Keeps the opacity of the pictures, in a webm, gif, webp or mov");
  command->add_option("--dpi", to->dpi, "Pixels an inch, which the copy of one picture says");
  command->add_option("--columns", to->columns, "Of a sheet")->check(CLI::Range(1, 1000));
  command->add_option("--width", to->width, "Pixels, of each picture of a sheet at most (240)")
      ->check(CLI::Range(1, 16384));
  command->footer(
      R"(It appears whole or not at all, and not where a picture is damaged. FROND_FFMPEG names another ffmpeg.

Examples:
  ls out/reef/frames/*.png > list
  frond film list reef.webm --fps 12
  frond film list sheet.png --columns 6)");
}

void add_render(CLI::App& app) {
  auto [command, to] =
      add_command(app, "render", "From a preset to a film or a still: generates, renders, encodes", render);
  add_preset(command, to->preset);
  add_pictures(command, to->preset);
  command->get_option("preset")->required(false)->description(
      "The preset, a JSON file; without it, which there are");
  add_run(command, *to);
  add_resolving(command, to->resolve);
  command->add_option("--format", to->format,
                      "mp4, webm, gif, webp or mov, of the film (mp4; mov where it is transparent)");
  command
      ->add_option(
          "--every", to->every,
          "K: renders each K-th frame first, then those between, with a film preview.mp4 of what there is")
      ->check(CLI::Range(1, 999'999'999));
  command->add_flag(
      "--watch", to->watch,
      "Shows in DIR/watch.png, once a second, the blocks that are traced of the picture so far");
  command->add_option("--plot", to->plot, "FILE.svg: draws nodes, bytes and seconds of each frame");
  command->add_option("--why", to->why, "N: renders nothing; says why frame N is out of date")
      ->check(CLI::Range(1, 999'999'999));
  command
      ->add_option("--compare", to->compare,
                   "A B [FILE]: as `frond compare`, two films or two pictures instead")
      ->expected(1, 3);
  add_sweeps(command, *to);
  command->footer(
      R"(Leaves DIR/film.mp4 and DIR/contact.png, or DIR/still.png where the preset is a still. Renders only what
changed: interrupted or killed at any moment and run again it goes on where it stopped, also within a
picture. The files made are named on stdout, all else goes to stderr.

Exit codes: 0 done, 1 could not (disk, POV-Ray), 2 wrong input, 130 interrupted. NO_COLOR=1 keeps messages
plain. FROND_POVRAY and FROND_FFMPEG name other programs than povray and ffmpeg.

Examples:
  frond render presets/reef.json
  frond render presets/reef.json --frames 1-48 --size 320x180 --quality draft -o out/check
  frond render presets/reef.json --size 1280x720 --quality best --set /seed=8 -o out/reef-8
  frond render presets/trees/oak.json --scale 4
  frond render --compare out/reef out/reef-8 both.mp4)");
}

void add_sheet(CLI::App& app) {
  auto [command, to] = add_command(
      app, "sheet", "A sheet of labelled stills of a preset, over seeds or over a value of it", sheet);
  add_preset(command, to->preset);
  add_pictures(command, to->preset);
  add_run(command, *to);
  add_sweeps(command, *to);
  command->footer(
      R"(Leaves DIR/sheet.png. Two of --sweep and --contact-seeds make a grid, the first from left to right. Of a
film it takes the last frame, or that of --frames N-N. Pictures are kept in DIR/pictures: the next sheet
renders only those that it does not find there.

Examples:
  frond sheet presets/trees/oak.json --contact-seeds 9 --size 320x240 --quality draft
  frond sheet presets/thicket.json --sweep /organisms/0/pitch=10:60:6 --sweep /organisms/0/steps=2:4:3)");
}

void add_compare(CLI::App& app) {
  auto [command, to] = add_command(
      app, "compare", "How much two films or two pictures differ, in figures and side by side", compare);
  command->add_option("a", to->a, "A picture, a film, or the folder of a run or of frames")->required();
  command->add_option("b", to->b, "Another of the same size")->required();
  command->add_option("file", to->out,
                      "FILE.png or FILE.mp4: both side by side, with their difference times four "
                      "(out/compare.png, out/compare.mp4; with --json none)");
  command->add_flag("--json", to->json, "For machines");
  command->footer(
      R"(All in steps of 255 of sRGB values: error is the root mean square difference over pixels, channels and
frames, maximum the greatest; share_beyond_8 is the share of pixels off by more than 8 in a channel.
Of films, flicker is the root mean square, over pixels and channels, of the standard deviation over time
of A - B. Where both are folders with frames/frame_*.png, or frame_*.png, the figures are of those that
both have.

Exit codes: 0 done, 1 could not (damaged), 2 wrong input (two sizes, a picture and a film).

Examples:
  frond compare out/reef out/reef-8 both.mp4
  frond compare out/reef out/reef-8 --json)");
}

void add_task(CLI::App& app) {
  auto [command, to] = add_command(
      app, "task", "Does one task of a film on a farm; called by scripts/farm_task.sh", farm_task);
  command->add_option("folder", to->folder, "Of the job, which frond farm has made")->required();
  command->add_option("cpus", to->cpus, "How many processors to use, 0 all")
      ->required()
      ->check(CLI::Range(0, 9999));
  command->add_option("work", to->work, "frames, bands or film")->required();
  command->add_option("words", to->words, "FIRST LAST CHUNK [TASK], or N [TASK]");
  command->footer(
      R"(Renders the TASK-th CHUNK of frames FIRST to LAST, or the TASK-th of N bands of a still, or makes the film of
what is rendered. Without TASK it is $SLURM_ARRAY_TASK_ID. It may be run again, anywhere, at any time, also
twice at once: what is finished is skipped.)");
}

void add_farm(CLI::App& app) {
  auto [command, to] = add_command(
      app, "farm", "Renders a film on many machines: by Slurm, over ssh, or on a farm that reads job files",
      farm);
  add_preset(command, to->preset);
  add_pictures(command, to->preset);
  command->add_option("-o,--out", to->out,
                      "DIR: where to (out/<preset name>), on a disk that all machines see");
  command->add_option("--frames", to->order.frames, "A-B: only these frames");
  command->add_option("--partition", to->order.partition, "P: where the jobs go");
  command->add_option("--site", to->site,
                      "FILE: what this site's farm needs, JSON: partition, account, qos, cpus, memory, "
                      "minutes, modules, options");
  command->add_option("--chunk", to->chunk, "N: frames a task (4)");
  command->add_option("--bands", to->bands, "N: tasks of a still (8)");
  add_resolving(command, to->order.resolve);
  command->add_option("--hosts", to->order.hosts,
                      "A,B,...: renders over ssh on these machines instead, by GNU parallel, and waits");
  command->add_option("--openjd", to->order.openjd,
                      "FILE: writes an Open Job Description template instead (jobtemplate-2023-09)");
  command->add_option("--opencue", to->order.opencue, "FILE: writes a job for OpenCue instead (CJSL 1.15)");
  command->add_flag("--status", to->status, "Says how far the film is");
  command->add_flag("--cancel", to->cancel, "Ends its jobs");
  command->add_flag("--logs", to->logs, "Prints the ends of their logs");
  command->footer(
      R"(A job array of Slurm renders the frames, a job that waits for them leaves DIR/film.mp4 and DIR/contact.png,
or DIR/still.png, which is rendered in bands. The same call again goes on where a farm was stopped: what is
finished is not rendered again. FROND_BIN, FROND_POVRAY, FROND_FFMPEG and FROND_UNCONFINED are handed on to the
tasks. See docs/farm.md.

Examples:
  frond farm presets/reef.json --partition render --size 1920x1080 --quality good
  frond farm presets/reef.json --hosts anna,berta,clara --frames 1-48
  frond farm presets/reef.json --status)");
}

void add_gallery(CLI::App& app) {
  auto [command, to] = add_command(
      app, "gallery",
      "Renders the pictures of docs/gallery that have changed, in the folder of Frond, and lists them",
      gallery);
  command->add_option("names", to->names, "Only these pictures");
  command->add_option("-o,--out", to->out, "DIR: keeps what they are made of (out/gallery)");
  command->add_flag("--large", to->large,
                    "Renders the best of them 1280 pixels wide, into docs/gallery/large");
  command->add_flag("--stale", to->stale,
                    "Renders nothing: names the pictures whose scenes are not what they show");
  command->footer(
      R"(docs/gallery/pictures.txt says which there are, and which are large ones; further ones are example-NAME, of each
scene in docs/examples, and grammars. Interrupted and run again it goes on where it stopped. docs/gallery.md lists
them with the seconds of processor that POV-Ray took, here or where they were rendered last.

docs/gallery/scenes.txt keeps a hash of the scene of each picture as it was rendered. --stale writes the scenes
anew and names, a line each, the pictures whose hash is another or not there; large ones as large/NAME. What it has
found it keeps in --out, so that nothing is written twice for the same program and preset.

Examples:
  frond gallery reef tree-oak
  frond gallery $(frond gallery --stale))");
}

}  // namespace frond
