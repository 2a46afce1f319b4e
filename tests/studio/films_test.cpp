#include "studio/films.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "scene/named_files.h"

namespace frond {
namespace {

namespace fs = std::filesystem;

class FilmsTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "frond-films-XXXXXX").string();
    folder_ = fs::canonical(mkdtemp(name.data()));
    (void)write_file(folder_ / "a.json", kText);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// A film that an earlier studio has left.
  fs::path earlier(const std::string& name, const std::string& told = "") const {
    fs::path film = folder_ / "out/films" / name;
    (void)write_file(film / "film.json", R"({"order": {"size": [16, 16], "quality": "draft", "range": "",
        "rough": true, "farm": false}, "told": {"title": "A", "seed": 1, "fps": 24, "frames": 9)" +
                                             told + R"(}, "rough": []})");
    return film;
  }

  static constexpr const char* kText = R"({"film": {"frames": 1}, "organisms": []})";
  fs::path folder_;
};

TEST_F(FilmsTest, TellsWhatCannotBeAFilm) {
  Documents documents({.home = FROND_ROOT, .preset = folder_ / "a.json", .assets = {}, .ready = {}});
  Films films(documents);
  Doc doc{kText, folder_ / "a.json"};
  EXPECT_NE(films.begin(doc, {}).errors().front().text().find("a still"), std::string::npos);
  FilmOrder order;
  order.quality = "fine";
  EXPECT_NE(films.begin(doc, order).errors().front().text().find("no quality"), std::string::npos);
  doc.text = R"({"seed": -1})";
  EXPECT_NE(films.begin(doc, {}).errors().front().text().find("/seed"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "out")) << "nothing was begun";
}

TEST_F(FilmsTest, FindsWhatEarlierStudiosLeft) {
  fs::path paused = earlier("a-1"), done = earlier("a-2");
  (void)write_file(done / "film.mp4", "film");
  fs::path clear = earlier("a-3", R"(, "transparent": true)");
  (void)write_file(clear / "rough/film.webm", "rough");
  (void)write_file(folder_ / "out/films/b-1/film.json", R"({"order": 3})");
  for (int frame : {1, 3}) (void)write_file(paused / fmt::format("frames/frame_000{}.png", frame), "png");
  Documents documents({.home = FROND_ROOT, .preset = folder_ / "a.json", .assets = {}, .ready = {}});
  Films films(documents);
  EXPECT_EQ(films.list().size(), 3u) << "what is no film is left out";
  Json state = *films.state("a-1");
  EXPECT_EQ(state["state"], "paused");
  EXPECT_EQ(state["there"], Json({1, 3}));
  EXPECT_EQ(state["done"], 2);
  EXPECT_EQ(state["of"], 9);
  EXPECT_EQ((*films.state("a-2"))["state"], "done");
  EXPECT_EQ((*films.state("a-2"))["film"], "film.mp4");
  EXPECT_EQ((*films.state("a-2"))["plays"], "film.mp4");
  EXPECT_FALSE(films.state("b-1"));

  // One with opacity is a .mov, and plays as another.
  EXPECT_EQ((*films.state("a-3"))["plays"], "rough.webm");
  EXPECT_EQ(films.file("a-3", "rough.webm"), clear / "rough/film.webm");
  (void)write_file(clear / "film.mov", "film");
  Films later(documents);
  EXPECT_EQ((*later.state("a-3"))["state"], "done");
  EXPECT_EQ((*later.state("a-3"))["film"], "film.mov");
  EXPECT_EQ((*later.state("a-3"))["plays"], "rough.webm") << "the whole one cannot be played";
  (void)write_file(clear / "film.webm", "film");
  EXPECT_EQ((*later.state("a-3"))["plays"], "film.webm");
  EXPECT_EQ(later.file("a-3", "film.mov"), clear / "film.mov");
  EXPECT_EQ(films.file("a-1", "3"), paused / "frames/frame_0003.png");
  EXPECT_EQ(films.file("a-2", "film.mp4"), done / "film.mp4");
  for (const char* name : {"2", "film.mp4", "film.json", "..", "frames/frame_0001.png", "-1"})
    EXPECT_FALSE(films.file("a-1", name)) << name;
  EXPECT_FALSE(films.pause("b-1") || films.resume("b-1") || films.remove("b-1"));
  EXPECT_TRUE(films.remove("a-1"));
  EXPECT_FALSE(fs::exists(paused));
}

TEST_F(FilmsTest, ACopyNamesItsFilesByTheirWholePaths) {
  (void)write_file(folder_ / "one.obj", "v 0 0 0");
  std::string text = R"({"organisms": [{"kind": "mesh", "file": "one.obj", "name": "two.obj"}]} // one.obj)";
  EXPECT_EQ(*with_whole_paths(text, folder_), R"({"organisms": [{"kind": "mesh", "file": ")" +
                                                  (folder_ / "one.obj").string() +
                                                  R"(", "name": "two.obj"}]} // one.obj)");
  EXPECT_EQ(*with_whole_paths("{", folder_), "{") << "what cannot be read stays as it is";
}

}  // namespace
}  // namespace frond
