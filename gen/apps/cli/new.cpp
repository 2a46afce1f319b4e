#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "cli/commands.h"
#include "cli/flower_bed.h"
#include "cli/inputs.h"
#include "cli/messages.h"
#include "cli/named.h"
#include "cli/streams.h"
#include "core/files.h"
#include "organisms/kinds.h"
#include "preset/json.h"
#include "preset/manual.h"
#include "scene/describe.h"
#include "settings/settings.h"

// A preset to begin with: new.

namespace frond {

namespace fs = std::filesystem;

namespace {

/// Writes a preset with the schema's sentences as comments.
class Commented {
 public:
  explicit Commented(std::vector<Topic> topics) : topics_(std::move(topics)) {}

  std::string text(const Value& root) {
    append_object(root, "", 0);
    return out_ + "\n";
  }

 private:
  const Topic* topic(const std::string& path) const {
    std::size_t slash = path.find('/');
    std::string common = slash == path.npos ? path : "organism" + path.substr(slash);
    for (const std::string& wanted : {path, common})
      for (const Topic& topic : topics_)
        if (topic.path == wanted) return &topic;
    return nullptr;
  }

  void line(int indent) { (out_ += '\n').append(static_cast<std::size_t>(indent), ' '); }

  void append_comment(const Topic& topic, int indent) {
    std::string words = topic.sentence;
    for (const auto& [name, doc] : topic.choices)
      words += (&name == &topic.choices.front().first ? ": " : ", ") + name;
    std::string limits = topic.range;
    if (!topic.unit.empty()) limits += (limits.empty() ? "" : " ") + topic.unit;
    // Bounds that nobody meets are left out.
    if (!limits.empty() && limits.find("00000") == limits.npos) words += " (" + limits + ")";
    append_wrapped(words, indent);
  }

  void append_wrapped(const std::string& words, int indent) {
    constexpr std::size_t kWidth = 100;
    std::string row;
    line(indent);
    out_ += "//";
    for (std::size_t from = 0; from < words.size();) {
      std::size_t to = std::min(words.find(' ', from), words.size());
      if (row.size() + to - from > kWidth) {
        out_ += row;
        line(indent);
        out_ += "//";
        row.clear();
      }
      row += " " + words.substr(from, to - from);
      from = to + 1;
    }
    out_ += row;
  }

  /// What else the object could have.
  void append_rest(const Value& object, const std::string& path, int indent) {
    std::string above = path.empty() ? "" : path + "/", rest;
    for (const Topic& topic : topics_) {
      if (!topic.path.starts_with(above)) continue;
      std::string name = topic.path.substr(above.size());
      if (name.find('/') != name.npos || object.find(name) || name == "kind") continue;
      // Among the blocks of settings only that of the preset's setting fits.
      bool fits = path != "scene" || name == "floor" || name == setting_;
      if (fits && !path.empty()) rest += (rest.empty() ? "" : ", ") + name;
    }
    if (rest.empty()) return;
    append_wrapped(fmt::format("More: {}; see `frond describe {}`", rest, path), indent);
  }

  void append_object(const Value& object, const std::string& path, int indent) {
    if (path == "scene")
      if (const Value* setting = object.find("setting"))
        for (const SettingRow& row : settings())
          if (row.name == setting->text) setting_ = row.block;
    out_ += '{';
    for (const Member& member : object.members) {
      std::string below = path.empty() ? member.name : path + "/" + member.name;
      const Topic* about = member.name == "$schema" ? nullptr : topic(below);
      if (about && about->path != "organism/kind") append_comment(*about, indent + 2);
      line(indent + 2);
      out_ += serialize(make_text(member.name)) + ": ";
      append(member.value, below, indent + 2);
      if (&member != &object.members.back()) out_ += ',';
    }
    append_rest(object, path, indent + 2);
    line(indent);
    out_ += '}';
  }

  void append(const Value& value, const std::string& path, int indent) {
    bool objects =
        value.is(Value::Type::list) && !value.items.empty() && value.items.front().is(Value::Type::object);
    if (value.is(Value::Type::object) && path != "grammar/constants")
      return append_object(value, path, indent);
    if (!objects) {
      std::string text = serialize_pretty(value, static_cast<std::size_t>(100 - indent));
      text.pop_back();
      for (char c : text) {
        out_ += c;
        if (c == '\n') out_.append(static_cast<std::size_t>(indent), ' ');
      }
      return;
    }
    out_ += '[';
    for (const Value& item : value.items) {
      line(indent + 2);
      const Value* kind = item.find("kind");
      append_object(item, path == "organisms" && kind ? kind->text : path, indent + 2);
      if (&item != &value.items.back()) out_ += ',';
    }
    line(indent);
    out_ += ']';
  }

  std::vector<Topic> topics_;
  std::string out_, setting_;
};

/// The names of files are seen from the folder of a preset: makes them fit another one. What names a file is
/// told by that it is there.
void move_files(Value& value, const fs::path& from, const fs::path& to, const fs::path& home) {
  for (Value& item : value.items) move_files(item, from, to, home);
  for (Member& member : value.members)
    if (member.name != "$schema") move_files(member.value, from, to, home);
  if (!value.is(Value::Type::text) || value.text.empty()) return;
  for (const fs::path& folder : {from, home}) {
    std::error_code error;
    fs::path file = folder / value.text;
    if (value.text.size() < 200 && fs::is_regular_file(file, error))
      return void(value.text = fs::proximate(file, to, error).generic_string());
  }
}

/// The file that a preset begins as: a kind's, or what preset_named() finds.
Result<fs::path> find_beginning(const std::string& from, const fs::path& home) {
  std::vector<std::string> names;
  for (const auto& row : organism_kinds()) {
    names.emplace_back(row.name);
    if (row.name == from) return home / "templates" / "new" / (from + ".json");
  }
  if (fs::path named = preset_named(from); is_file(named)) return named;
  for (const fs::path& file : files_below(home / "presets"))
    if (file.extension() == ".json" && !is_grammar(file.string())) names.push_back(file.stem().string());
  std::vector<std::string_view> views(names.begin(), names.end());
  return error_at("--from", "\"{}\" is no kind, and no preset{}", from, expected_names(from, views));
}

Result<Value> read_beginning(const fs::path& file, const std::string& kind) {
  if (!path_exists(file))  // a kind that nobody wrote a beginning for
    return make_object().set("organisms", make_list({make_object().set("kind", make_text(kind))}));
  Result<std::string> text = read_file(file);
  if (!text) return text.errors();
  Result<Document> document = parse_json(*text, file.string());
  if (!document) return document.errors();
  return std::move(document->root);
}

}  // namespace

void new_preset(const NewArguments& arguments) {
  fs::path root = or_fail(home(), kCouldNot);
  fs::path path = arguments.name.ends_with(".json") ? arguments.name : arguments.name + ".json";
  std::error_code error;
  if (fs::exists(path, error))
    fail({Error{path.string(), "is there already; expected a name that is free"}}, kWrongInput);
  bool bed = !arguments.with.empty();
  fs::path from = or_fail(bed ? fs::path() : find_beginning(arguments.from, root), kWrongInput);
  Value read = or_fail(bed ? flower_bed(arguments.with) : read_beginning(from, arguments.from), kWrongInput);

  fs::path folder = fs::absolute(path, error).parent_path();
  move_files(read, fs::absolute(from, error).parent_path(), folder, root);
  Value preset = make_object();
  preset.set("$schema",
             make_text(fs::proximate(root / "docs" / "preset.schema.json", folder, error).generic_string()));
  preset.set("title", make_text(path.stem().string()));
  // What begins as a preset that is there grows as that does; what begins as a kind, by the rules of today.
  bool from_kind =
      std::ranges::any_of(organism_kinds(), [&](const auto& row) { return row.name == arguments.from; });
  if (bed || from_kind) preset.set("version", make_number(kPresetVersion));
  preset.set("seed", make_number(1));
  for (Member& member : read.members)
    if (member.name != "$schema" && member.name != "title") preset.set(member.name, std::move(member.value));

  std::string text = Commented(topics_of(preset_schema())).text(preset);
  or_fail(write_file(path, text), kCouldNot);
  put(path.string() + "\n");
  const Value* organisms = preset.find("organisms");
  const Value* kind =
      organisms && !organisms->items.empty() ? organisms->items.front().find("kind") : nullptr;
  if (arguments.quiet) return;
  tell("Next:");
  if (std::string render = render_command(); !render.empty())
    tell(fmt::format("  {} {}        a picture or a film of it, below out/", render, path.string()));
  tell(fmt::format("  {} studio {} --open      sliders and a live view", arguments.program, path.string()));
  if (kind)
    tell(fmt::format("  {} describe {}        what each property does", arguments.program, kind->text));
}

}  // namespace frond
