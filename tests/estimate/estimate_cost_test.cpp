#include "estimate/estimate_cost.h"

#include <gtest/gtest.h>

#include "core/files.h"
#include "draw/ambience.h"
#include "emit/setting.h"
#include "emit/texts.h"
#include "film/soft_light.h"
#include "settings/meadow.h"

namespace frond {
namespace {

Preset preset_at(const std::string& path, const std::vector<std::string>& sets = {}) {
  return *read_preset(*read_file(FROND_ROOT "/" + path), path, sets);
}

CostEstimate estimate_of(const Preset& preset) { return *estimate_cost(preset, {1, preset.film.frames}); }

TEST(CostEstimate, IsWithinAFactorOfTwoOfWhatIsWritten) {
  std::string layout = *read_file(FROND_ROOT "/templates/frame.pov");
  for (const char* path :
       {"presets/bush.json", "presets/fan.json", "tests/presets/staghorn.json", "presets/tufted.json",
        "presets/lsystems/trees-2.6.json", "presets/lsystems/plants-1.24.json",
        "presets/lsystems/sunflower-4.json", "presets/garden/bush.json", "presets/garden/tree.json",
        "presets/garden/palm.json", "presets/ivy/brick_wall.json", "presets/heart_tree.json",
        "presets/trees/poplar.json", "presets/aspen.json"}) {
    SCOPED_TRACE(path);
    // The last frame, in which all is grown.
    Preset preset = preset_at(path);
    CostEstimate f = estimate_of(preset);
    Scene scene = *build_scene(preset);
    FrameParts parts = prepare_frames(scene);
    auto nodes = static_cast<double>(scene.nodes());
    auto bytes = static_cast<double>(frame_text(scene, parts, layout, preset.film.frames)->size());
    if (has_soft_light(scene.setup) && light_changes(scene, parts.pixel)) {
      double end = scene.film.time(preset.film.frames);
      bytes +=
          static_cast<double>(soft_light_text(parts.space, scene, parts.plan.surfels, end, true)->size());
    }
    EXPECT_GE(f.nodes, nodes / 2);
    EXPECT_LE(f.nodes, nodes * 2 + 50);
    EXPECT_GE(f.frame_bytes, bytes / 2);
    EXPECT_LE(f.frame_bytes, bytes * 2);
  }
}

TEST(CostEstimate, CountsModelsOfWhatIsSownAndNotTheirCopies) {
  auto with = [](const char* count) {
    return estimate_of(preset_at("tests/presets/all_phases.json", {std::string("/organisms/2/count=") + count,
                                                                   "/organisms/2/sown/where/radius=0.3"}));
  };
  CostEstimate few = with("30"), many = with("3000");
  EXPECT_EQ(many.copies - few.copies, 2970);
  EXPECT_EQ(many.models, few.models);
  EXPECT_EQ(many.nodes, few.nodes);
  EXPECT_LT(many.scene_memory, 1.1 * few.scene_memory);
}

TEST(CostEstimate, CountsLittleOfWhatHasHardlyGrownInTheFirstFrames) {
  Preset preset = preset_at("presets/lsystems/growing-tree-2.6.json");
  int last = preset.film.frames;
  CostEstimate first = *estimate_cost(preset, {1, 1}), whole = *estimate_cost(preset, {last, last});
  EXPECT_GT(first.ungrown_bytes, 0);
  EXPECT_EQ(whole.ungrown_bytes, 0);
  EXPECT_LT(first.written(), whole.written());
  EXPECT_EQ(first.frame_bytes, whole.frame_bytes) << "the most that a frame has";
}

TEST(CostEstimate, KnowsThatLongRowsOfASheetTakeLongerEach) {
  auto seconds = [](const char* edge) {
    return estimate_of(preset_at("templates/new/table.json",
                                 {"/organisms/0/across=0.2", std::string("/organisms/0/edge=") + edge}))
        .growth_seconds;
  };
  EXPECT_GT(seconds("0.0005"), 8 * seconds("0.001"));  // 26 s and 3
}

TEST(CostEstimate, RefusesAFilmThatTheDiskCannotHold) {
  Preset preset = preset_at("tests/presets/staghorn.json", {"/film/frames=100000"});
  CostEstimate f = estimate_of(preset);
  Machine machine;
  EXPECT_TRUE(refuse(f, machine).empty());
  machine.disk = 80e9;
  Errors errors = refuse(f, machine);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_NE(errors[0].what.find("GB, 100000 frames"), std::string::npos) << errors[0].what;
  EXPECT_NE(errors[0].what.find("80 GB of the disk are free"), std::string::npos) << errors[0].what;
  EXPECT_TRUE(refuse(*estimate_cost(preset, {1, 24}), machine).empty());
}

TEST(CostEstimate, ReckonsRenderingByPixelsAndQuality) {
  // Seconds of a processor, measured at 160x90 when it was busy elsewhere, too.
  struct Row {
    const char* preset;
    double draft, good;
  };
  for (const Row& row : {Row{"reef", 4.1, 7.8}, Row{"bush", 1.7, 4.6}, Row{"lsystems/trees-2.6", 2.7, 5.5},
                         Row{"ivy/brick_wall", 2.3, 6.5}}) {
    auto seconds = [&](const char* size, const char* quality) {
      return estimate_of(
                 preset_at(std::string("presets/") + row.preset + ".json",
                           {std::string("/film/size=") + size, std::string("/film/quality=") + quality}))
          .render_seconds;
    };
    SCOPED_TRACE(row.preset);
    EXPECT_GT(seconds("[160,90]", "draft"), row.draft / 2);
    EXPECT_LT(seconds("[160,90]", "draft"), row.draft * 2);
    EXPECT_GT(seconds("[160,90]", "good"), row.good / 2);
    EXPECT_LT(seconds("[160,90]", "good"), row.good * 2);
    EXPECT_GT(seconds("[160,90]", "best"), seconds("[160,90]", "good"));
    EXPECT_GT(seconds("[640,360]", "good"), 4 * row.good);
  }
}

TEST(CostEstimate, CountsPicturesByTheirPixels) {
  auto bytes = [](const char* size) {
    return estimate_of(preset_at("tests/presets/staghorn.json", {std::string("/film/size=") + size}))
        .picture_bytes;
  };
  EXPECT_NEAR(bytes("[640,360]"), 16 * bytes("[160,90]"), 1);
  EXPECT_NEAR(bytes("[320,200]"), bytes("[200,320]"), 1);
  // POV-Ray's PNG of 8 bits has 3 bytes a pixel before it is packed.
  EXPECT_GT(bytes("[640,360]"), 0.5 * 640 * 360);
  EXPECT_LT(bytes("[640,360]"), 3 * 640 * 360);
}

TEST(CostEstimate, RefusesWhatTheMemoryCannotHold) {
  Preset preset = preset_at("presets/lsystems/trees-2.8.json", {"/organisms/0/grammar/steps=14"});
  CostEstimate f = estimate_of(preset);
  EXPECT_GT(f.nodes, 1e7);
  Machine machine;
  machine.memory = 1e9;
  Errors errors = refuse(f, machine);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_NE(errors[0].what.find("1 GB can be had; /organisms/0 takes most"), std::string::npos)
      << errors[0].what;
  machine.memory = 1e11;
  EXPECT_TRUE(refuse(f, machine).empty());
}

TEST(CostEstimate, WritesFewerFramesAtATimeWhereMemoryIsShort) {
  CostEstimate f;
  f.frames = 24;
  f.scene_memory = 1e9;
  f.frame_memory = 2e9;
  Machine machine{1e12, 1e12, 16};
  EXPECT_EQ(f.at_once(machine), 16);
  machine.memory = 10e9;
  EXPECT_EQ(f.at_once(machine), 3);
  machine.memory = 2e9;
  EXPECT_EQ(f.at_once(machine), 1);
}

TEST(CostEstimate, DoesNotGrowAnOldTreeToEstimateIt) {
  auto nodes = [](const char* years) {
    return estimate_of(preset_at("presets/trees/oak.json", {std::string("/organisms/0/years=") + years}))
        .nodes;
  };
  double young = nodes("34"), old = nodes("400");
  EXPECT_GT(old, 3 * young);
  EXPECT_LT(old, 40 * young);
}

TEST(CostEstimate, CountsThePixelsOfBark) {
  auto with = [](const char* pixels) {
    return estimate_of(
        preset_at("presets/trees/birch.json",
                  {std::string("/organisms/0/coat/pixels=") + pixels, "/organisms/0/years=6"}));
  };
  CostEstimate small = with("64"), large = with("4096");
  EXPECT_GT(large.seconds() - small.seconds(), 30);
  EXPECT_GT(large.memory(1), 2.5e8);
  EXPECT_GT(large.shared_bytes - small.shared_bytes, 1e7);
}

TEST(CostEstimate, CountsTheLayersOfACoralThatGrowsByThem) {
  auto with = [](const char* up) {
    return estimate_of(
        preset_at("presets/species/corals/finger.json", {std::string("/organisms/0/accretion/up=") + up}));
  };
  CostEstimate low = with("0.2"), high = with("5");
  EXPECT_LT(low.seconds(), 6);
  EXPECT_GT(high.seconds(), 10 * low.seconds());
  EXPECT_GT(high.memory(1), low.memory(1) + 1e8);
}

TEST(CostEstimate, CountsTheVolumeOfFusedBranches) {
  auto with = [](const char* body) {
    return estimate_of(
        preset_at("presets/fused.json", {std::string("/organisms/0/body={\"build\": ") + body + "}"}));
  };
  CostEstimate sweeps = with(R"("sweeps")"), fused = with(R"("fused", "voxel": 0.004)"),
               finer = with(R"("fused", "voxel": 0.002)");
  EXPECT_GT(fused.frame_seconds, sweeps.frame_seconds + 0.5);
  EXPECT_GT(finer.frame_seconds, 2 * fused.frame_seconds);
  EXPECT_GT(finer.frame_bytes, 2 * fused.frame_bytes);
}

TEST(CostEstimate, CountsThePictureOfCaustics) {
  auto with = [](const char* caustics) {
    return estimate_of(preset_at("presets/reef/starfish.json",
                                 {std::string("/scene/water/caustics=") + caustics, "/film/frames=10"}));
  };
  CostEstimate none = with("0"), some = with("1");
  EXPECT_LT(none.frame_bytes, some.frame_bytes);
  EXPECT_LT(none.frame_seconds, some.frame_seconds);
  EXPECT_LT(none.render_seconds, some.render_seconds);
}

TEST(CostEstimate, AnswersOfAHundredThousandSteps) {
  // The word grows by a module a step, so that all of them have five thousand million.
  CostEstimate f = estimate_of(
      preset_at("presets/lsystems/koch-1.6.json", {R"(/organisms/0/grammar={"axiom": "A", "steps": 100000,
                                       "rules": ["A -> FA"]})"}));
  EXPECT_EQ(f.modules, 100001);
  EXPECT_GT(f.seconds(), 60);
}

TEST(CostEstimate, CountsNoMoreFramesAtATimeThanThereAre) {
  CostEstimate f;
  f.frame_memory = 1e6;
  f.frames = 2;
  Machine machine{1e12, 1e12, 16};
  EXPECT_EQ(f.at_once(machine), 2);
  f.exposures = 5;
  EXPECT_EQ(f.at_once(machine), 10);
}

TEST(CostEstimate, AnOldTreeHasDroppedItsLeavesAndTwigs) {
  auto nodes = [](const char* lifespan) {
    CostEstimate f = estimate_of(
        preset_at("presets/trees/dead_tree.json", {std::string("/organisms/0/habit/lifespan=") + lifespan}));
    return std::pair{f.nodes, f.organs};
  };
  EXPECT_EQ(nodes("34").second, 0);
  EXPECT_LT(nodes("34").first, 0.3 * nodes("60").first);
}

TEST(CostEstimate, CountsTheFruit) {
  auto organs = [](const char* share) {
    Preset preset =
        preset_at("tests/presets/tiny_film.json",
                  {R"(/organisms=[{"kind": "tree", "years": 9, "season": {"at": 0.7, "evergreen": true,
      "fruit": {"share": 0, "cluster": 6, "ripe": [0.5, 0.55], "fall": [0.8, 0.85]}}}])",
                   std::string("/organisms/0/season/fruit/share=") + share});
    Model model = build_scene(preset)->specimens[0].model;
    in_season(model, *preset.organisms[0].grower->appearance().season, 0, Seed{1});
    return std::pair{estimate_of(preset).organs, static_cast<double>(model.organs.size())};
  };
  const auto [bare, bare_there] = organs("0");
  const auto [bearing, there] = organs("0.5");
  EXPECT_GT(bearing / bare, 0.5 * there / bare_there);
  EXPECT_LT(bearing / bare, 2 * there / bare_there);
}

TEST(CostEstimate, AViewHasNoLightAndNoText) {
  // What takes longer than this opens with a question (PATIENCE of the page).
  constexpr double kPatience = 8;
  for (const char* path : {"presets/trees/oak.json", "presets/lsystems/plants-1.24.json", "presets/bush.json",
                           "presets/forest/sapling.json", "presets/trees/birch.json", "presets/aspen.json"}) {
    ViewCostEstimate view = *estimate_view_cost(preset_at(path));
    EXPECT_LT(view.wait(2), kPatience) << path;
    EXPECT_TRUE(refuse(view, Machine{4e9, 1, 2}).empty()) << path;
  }
  EXPECT_GT(estimate_view_cost(preset_at("presets/forest.json"))->wait(1), kPatience);
  Machine small;
  small.memory = 1e7;
  EXPECT_EQ(refuse(*estimate_view_cost(preset_at("presets/bush.json")), small).size(), 1u);
}

TEST(CostEstimate, CountsMasksInMemory) {
  Preset preset = preset_at("presets/garden/bush.json");
  double bare = estimate_of(preset).memory(1);
  Mask& map = preset.setup.block<Meadow>().lawn.map;
  map.width = map.height = 4096;
  map.grey = std::make_shared<const std::vector<float>>(4096u * 4096u, 0.5f);
  double held = 4.0 * 4096 * 4096;
  EXPECT_GT(estimate_of(preset).memory(1), bare + 0.9 * held);
  EXPECT_LT(estimate_of(preset).memory(1), bare + 4 * held);
}

TEST(CostEstimate, RefusesAStillWhoseTracingFillsTheDisk) {
  Preset preset = preset_at("tests/presets/tiny_still.json");
  preset.film.raw = true, preset.film.frames = 1, preset.film.size = {16000, 16000};
  CostEstimate estimate = estimate_of(preset);
  // POV-Ray notes 20 bytes of each sample, and has a file for those that it does not hold.
  EXPECT_NEAR(estimate.tracing_disk, 40.0 * 32000 * 32000, 1e6);
  Machine machine{.memory = 2e10, .disk = 2 * estimate.disk(), .threads = 8};
  Errors errors = refuse(estimate, machine);
  ASSERT_FALSE(errors.empty());
  EXPECT_EQ(errors.front().where, "/film/size");
  machine.disk += estimate.tracing_disk;
  EXPECT_TRUE(refuse(estimate, machine).empty());
}

TEST(CostEstimate, RefusesPicturesThatCannotBeResolved) {
  Preset preset = preset_at("tests/presets/tiny_garden.json");
  preset.film.raw = true, preset.film.frames = 100, preset.film.size = {16384, 16384};
  Machine machine{.memory = 2e10, .disk = 1e15, .threads = 8};
  Errors errors = refuse(estimate_of(preset), machine);
  ASSERT_FALSE(errors.empty());
  EXPECT_EQ(errors.front().where, "/film/size");
  EXPECT_NE(errors.front().what.find("--no-resolve"), std::string::npos);
  preset.film.frames = 1;  // a still is made in bands
  EXPECT_LT(estimate_of(preset).resolve_memory, 1e10);
  preset.setup.camera.aperture = 2;
  EXPECT_GT(estimate_of(preset).resolve_memory, 1e11) << "through a lens light comes from everywhere";
}

}  // namespace
}  // namespace frond
