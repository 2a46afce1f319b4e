#include "jobs/jobs.h"

#include <gtest/gtest.h>

#include <numeric>

#include "core/frame_name.h"

namespace frond {
namespace {

JobList film_of(int frames) {
  JobList jobs;
  jobs.frames.resize(static_cast<std::size_t>(frames));
  std::iota(jobs.frames.begin(), jobs.frames.end(), 1);
  return jobs;
}

bool contains(const std::string& text, std::string_view part) { return text.find(part) != text.npos; }

int count(std::string_view text, std::string_view part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + part.size())) ++found;
  return found;
}

/// What stands from `begin` to the next empty line.
std::string paragraph(const std::string& text, std::string_view begin) {
  std::size_t at = text.find(begin);
  return at == text.npos ? "" : text.substr(at, text.find("\n\n", at) - at);
}

TEST(NinjaText, RendersEachFrameOfTheList) {
  JobList jobs = film_of(3);
  jobs.includes = {"frond_sea.inc", "frond_skin.inc"};
  std::string text = ninja_text(jobs);
  EXPECT_EQ(count(text, ": frame frames/"), 3);
  EXPECT_TRUE(
      contains(text, "build frames/frame_0002.png: frame frames/frame_0002.pov | includes\n  number = 2\n"));
  EXPECT_TRUE(contains(text, "build includes: phony $povinc/frond_sea.inc $povinc/frond_skin.inc\n"));
  EXPECT_TRUE(contains(text, "size = 480x270\n"));
  EXPECT_TRUE(contains(text, "command = exec $frond frame $in $out $size -- $flags\n"));
}

TEST(NinjaText, ResolvesFramesFromRawOnes) {
  JobList jobs = film_of(3);
  jobs.frames = {2};
  jobs.raws = {1, 2, 3};
  jobs.window = 1;
  jobs.resolve = {"it's.json", "--film=."};
  std::string text = ninja_text(jobs);
  EXPECT_EQ(count(text, ": frame frames/"), 3);
  EXPECT_TRUE(contains(text, "build raw/frame_0003.png: frame frames/frame_0003.pov\n"));
  EXPECT_TRUE(contains(text, "flags = -A -J\n"));
  EXPECT_EQ(
      paragraph(text, "build $\n    frames/frame_0002.png"),
      "build $\n    frames/frame_0002.png: resolve $\n    raw/frame_0001.png $\n    raw/frame_0002.png $\n"
      "    raw/frame_0003.png\n  numbers = 2-2");
  EXPECT_TRUE(contains(text, "command = exec $frond resolve $preset --frames $numbers\n"));
  EXPECT_TRUE(contains(text, "\n  numbers = 2-2\n"));
  EXPECT_EQ(ninja_variable(text, "preset"), "'it'\\''s.json' '--film=.'");
}

TEST(NinjaText, ResolvesBlocksOfFramesFromTheRawOnesAroundThem) {
  JobList jobs = film_of(200);
  jobs.raws = jobs.frames;
  jobs.window = 4;
  std::string text = ninja_text(jobs);
  EXPECT_EQ(count(text, ": resolve "), 3);
  std::string second = paragraph(text, "build $\n    frames/frame_0097.png");
  EXPECT_TRUE(contains(second, "frames/frame_0192.png: resolve $\n    raw/frame_0093.png"));
  EXPECT_TRUE(contains(second, "raw/frame_0196.png\n  numbers = 97-192"));
  EXPECT_EQ(count(second, "raw/"), 104);
  jobs.rendered = true;
  text = ninja_text(jobs);
  EXPECT_EQ(count(text, ": frame "), 0);
  EXPECT_EQ(count(text, ": resolve "), 3) << "raw frames come from elsewhere, too";
}

TEST(NinjaText, FilmHoldsTheFramesOfTheListOnly) {
  JobList jobs = film_of(3);
  jobs.frames = {5, 6};
  jobs.fps = 12.5;
  std::string text = ninja_text(jobs);
  EXPECT_EQ(paragraph(text, "build film.mp4"),
            "build film.mp4: film $\n    frames/frame_0005.png $\n    frames/frame_0006.png");
  EXPECT_EQ(count(text, "frames/frame_0006.png"), 6) << "rendered, in each format of the film, on the sheet";
  EXPECT_TRUE(contains(text, "\ndefault film.mp4 contact.png\n"));
  EXPECT_TRUE(contains(text, "fps = 12.5\n"));
  EXPECT_FALSE(contains(text, "still.png"));
  EXPECT_FALSE(contains(text, "includes:"));
}

TEST(NinjaText, ContactSheetIsEvenlySpaced) {
  struct Row {
    int frames, pictures;
    std::string columns;
  };
  for (const Row& row :
       {Row{1, 1, "1"}, Row{6, 6, "3"}, Row{24, 24, "6"}, Row{72, 24, "6"}, Row{10000, 24, "6"}}) {
    std::string text = ninja_text(film_of(row.frames));
    std::string sheet = paragraph(text, "build contact.png");
    EXPECT_EQ(count(sheet, "frames/frame_"), row.pictures) << row.frames;
    EXPECT_TRUE(contains(sheet, "frame_0001.png")) << row.frames;
    EXPECT_TRUE(contains(sheet, frame_name(row.frames) + ".png")) << row.frames;
    EXPECT_TRUE(contains(text, "columns = " + row.columns + "\n")) << row.frames;
  }
}

TEST(NinjaText, StillHasNoFilm) {
  JobList jobs = film_of(1);
  jobs.still = true;
  std::string text = ninja_text(jobs);
  EXPECT_TRUE(contains(text, "build still.png: still $\n    frames/frame_0001.png\n"));
  EXPECT_TRUE(contains(text, "command = exec $frond film $out.list $out\n"));
  EXPECT_FALSE(contains(text, "film.mp4"));
}

TEST(NinjaText, OnlyTheFilmIsMadeOfPicturesFromElsewhere) {
  JobList jobs = film_of(2);
  jobs.includes = {"frond_sea.inc"};
  jobs.rendered = true;
  std::string text = ninja_text(jobs);
  EXPECT_FALSE(contains(text, ".pov"));
  EXPECT_FALSE(contains(text, "frond_sea.inc"));
  EXPECT_TRUE(
      contains(text, "build film.mp4: film $\n    frames/frame_0001.png $\n    frames/frame_0002.png\n"));
  EXPECT_TRUE(contains(text, "size = 480x270\n"));
}

TEST(NinjaText, SizeAndQualityStandInTheCommands) {
  JobList jobs = film_of(1);
  std::string before = ninja_text(jobs);
  jobs.quality = "best";
  EXPECT_NE(ninja_text(jobs), before);
  for (const Rendering& rendering : kRenderings) {
    jobs.quality = rendering.quality;
    EXPECT_TRUE(contains(ninja_text(jobs), rendering.flags.substr(1, 4)));
    EXPECT_TRUE(contains(std::string(rendering.flags), "-J")) << "jitter makes pixels depend on luck";
  }
}

TEST(NinjaText, OddCharactersAreEscaped) {
  JobList jobs = film_of(1);
  jobs.povinc = "../it's $HOME|x/povinc";
  jobs.program = "../it's $HOME/frond";
  jobs.includes = {"a b.inc"};
  jobs.title = "Reef: $(date)\n`id`";
  jobs.seed = 18446744073709551615ull;
  std::string text = ninja_text(jobs);
  EXPECT_TRUE(contains(text, "povinc = ../it's $$HOME|x/povinc\n"));
  EXPECT_TRUE(contains(text, "frond = '../it'\\''s $$HOME/frond'\n"));
  EXPECT_TRUE(contains(text, "$povinc/a$ b.inc"));
  EXPECT_TRUE(contains(
      text, "title = '--title=Reef: $$(date) `id`'\ncomment = '--comment=seed 18446744073709551615'\n"));
}

TEST(ManifestText, SaysWhatTheFilmIsMadeOf) {
  Manifest manifest;
  manifest.version = "0.1.0";
  manifest.preset = "reef";
  manifest.title = "A \"reef\"";
  manifest.preset_hash = "0123abcd";
  manifest.seed = 18446744073709551615ull;
  manifest.render_seconds = 1.25;
  manifest.frames = {{1, 0, 0}, {2, 1 / 24.0, 17}};
  EXPECT_EQ(manifest_text(manifest),
            "{\n"
            "  \"tool\": \"frond\",\n"
            "  \"version\": \"0.1.0\",\n"
            "  \"preset\": \"reef\",\n"
            "  \"title\": \"A \\\"reef\\\"\",\n"
            "  \"preset_hash\": \"0123abcd\",\n"
            "  \"seed\": 18446744073709551615,\n"
            "  \"fps\": 24,\n"
            "  \"size\": [480, 270],\n"
            "  \"quality\": \"draft\",\n"
            "  \"still\": false,\n"
            "  \"render_seconds\": 1.25,\n"
            "  \"frames\": [\n"
            "    {\"number\": 1, \"time\": 0, \"nodes\": 0, \"file\": \"frames/frame_0001.pov\"},\n"
            "    {\"number\": 2, \"time\": 0.041667, \"nodes\": 17, \"file\": \"frames/frame_0002.pov\"}\n"
            "  ]\n"
            "}\n");
}

TEST(NinjaText, GivesItsVariablesBack) {
  JobList jobs = film_of(2);
  jobs.title = "costs $5";
  std::string text = ninja_text(jobs);
  EXPECT_EQ(ninja_variable(text, "size"), "480x270");
  EXPECT_EQ(ninja_variable(text, "flags"), povray_flags(jobs.quality, false));
  EXPECT_EQ(ninja_variable(text, "title"), "'--title=costs $5'");
  EXPECT_EQ(ninja_variable(text, "none"), "");
}

TEST(ManifestText, IsReadAsItWasWritten) {
  Manifest manifest;
  manifest.preset = "a \"reef\"";
  manifest.title = "Reef: ä";
  manifest.fps = 12.5;
  manifest.size = {80, 60};
  manifest.still = true;
  manifest.render_seconds = 1.25;
  manifest.raw = {3, 12};
  manifest.budgets = {{"/organisms/0/budget", 1.5, 52000}, {"/organisms/2/budget", 3, 7}};
  manifest.frames = {{7, 0.25, 100}, {8, 0.5, 0}};
  Result<Manifest> read = read_manifest(manifest_text(manifest), "manifest.json");
  ASSERT_TRUE(read);
  EXPECT_EQ(manifest_text(*read), manifest_text(manifest));
  EXPECT_EQ(read->budgets[1].internodes, 7);
  EXPECT_FALSE(read_manifest("{}", "manifest.json"));
  EXPECT_FALSE(read_manifest("{", "manifest.json"));
}

TEST(Jobs, AFrameIsRenderedAgainWhereOneOfItsExposuresChanged) {
  JobList jobs;
  jobs.frames = {7};
  jobs.exposures = 3;
  jobs.includes = {"frond_sea.inc"};
  EXPECT_NE(ninja_text(jobs).find(
                "build frames/frame_0007.png: frame frames/frame_0007.pov | frames/frame_0007_s2.pov "
                "frames/frame_0007_s3.pov includes\n"),
            std::string::npos);
}

/// A lens takes many rays for each sample, so there are fewer of these.
TEST(Jobs, ALensHasFlagsOfItsOwn) {
  JobList jobs;
  jobs.frames = {1};
  jobs.quality = "good";
  EXPECT_NE(ninja_text(jobs).find("flags = +A0.0 +AM1 +R3 -J\n"), std::string::npos);
  jobs.lens = true;
  EXPECT_NE(ninja_text(jobs).find("flags = +A0.0 +AM1 +R2 -J\n"), std::string::npos);
  EXPECT_EQ(povray_flags("no such", true), "");
}

}  // namespace
}  // namespace frond
