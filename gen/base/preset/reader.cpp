#include "preset/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/assets.h"

namespace frond {

const Value* Reader::consume(std::string_view name) {
  Frame& frame = frames_.back();
  frame.names.push_back(name);
  if (!frame.value->is(Value::Type::object)) return name == frame.bare ? frame.value : nullptr;
  return frame.value->find(name);
}

void Reader::warn_of_radians(const Value& value, double found, double usual) {
  bool small = found != 0 && std::abs(found) <= 1.6 && found != std::round(found);
  if (!small || std::abs(usual) < 10) return;
  warnings_.add(
      {value.origin, pointer_,
       fmt::format("{:g} degrees are very few (usual are about {:g}); if radians were meant, write {:.1f}",
                   found, usual, degrees(found))});
}

void Reader::shorthand(std::string_view name) { frames_.back().bare = name; }

std::optional<NamedFile> Reader::file_at(const Value& value) {
  if (value.text.empty()) return std::nullopt;
  // A base or a species names its files as seen from its own folder.
  const Origin& origin = value.origin;
  bool written = origin.source && origin.line > 0;
  Result<NamedFile> file =
      written ? assets_->read(value.text, std::filesystem::path(*origin.source).parent_path())
              : assets_->read(value.text);
  if (file) return std::move(*file);
  for (const Error& error : file.errors()) faults_.add({value.origin, pointer_, error.text()});
  return std::nullopt;
}

void Reader::note_faults(const Value& value, const NamedFile& file, const Errors& errors) {
  for (const Error& error : errors)
    faults_.add({value.origin, pointer_,
                 error.where.empty() ? Error{file.path.string(), error.what}.text() : error.text()});
}

void Reader::origin(std::string& out, std::string_view name) {
  const Value& object = *frames_.back().value;
  const Value* member = name.empty() ? &object : object.find(name);
  std::string pointer = name.empty() ? pointer_ : pointer_step(pointer_, name);
  out = Fault{(member ? member : &object)->origin, std::move(pointer), ""}.error().where;
}

void Reader::given(std::string_view name, bool& out) {
  const Value* member = frames_.back().value->find(name);
  out = member && !member->inherited;
}

void Reader::required(std::string_view name) {
  const Value& object = *frames_.back().value;
  if (partial_ || !object.is(Value::Type::object) || object.find(name)) return;
  faults_.add({object.origin, pointer_, fmt::format("no \"{}\"; expected this property to be given", name)});
}

void Reader::leave() {
  Frame frame = std::move(frames_.back());
  frames_.pop_back();
  if (!frame.value->is(Value::Type::object)) {
    if (frame.bare.empty()) fault(*frame.value, "an object");
    return;
  }
  for (const Member& member : frame.value->members) {
    bool known = std::ranges::find(frame.names, member.name) != frame.names.end();
    // What a default brings that this kind does not have was judged with the defaults.
    if (known || member.value.inherited) continue;
    std::vector<std::string_view> names = frame.names;
    std::erase(names, "$schema");
    faults_.add({member.origin, pointer_step(pointer_, member.name), "", member.name, std::move(names)});
  }
}

std::nullopt_t Reader::fault(const Value& value, std::string_view expected) {
  bool bare = !frames_.empty() && &value == frames_.back().value && !frames_.back().bare.empty();
  std::string what =
      fmt::format("found {}; expected {}{}", found_text(value), expected, bare ? " or an object" : "");
  faults_.add({value.origin, pointer_, std::move(what)});
  return std::nullopt;
}

bool Reader::check_list(const Value& value, const Count& count) {
  bool open = count.max == Count{}.max;
  std::size_t size = value.items.size();
  if (value.is(Value::Type::list) && size >= count.min && size <= count.max) return true;
  std::string many = open && count.min == 0   ? ""
                     : open                   ? fmt::format(" of {} or more", count.min)
                     : count.min == count.max ? fmt::format(" of {}", count.min)
                                              : fmt::format(" of {} to {}", count.min, count.max);
  fault(value, "a list" + many);
  return false;
}

bool Reader::check_path(const Value& value, std::string_view path, const Value& schema) {
  const Value* here = &schema;
  for (;;) {
    std::string_view step = path.substr(0, path.find('/'));
    const Value* properties = here->find("properties");
    std::vector<std::string_view> names;
    if (properties) {
      for (const Member& member : properties->members) names.push_back(member.name);
    }
    here = properties ? properties->find(step) : nullptr;
    if (!here) {
      std::string what =
          fmt::format("unknown property {}{}", serialize(make_text(step)), expected_names(step, names));
      faults_.add({value.origin, pointer_, std::move(what)});
      return false;
    }
    if (step.size() == path.size()) return true;
    path.remove_prefix(step.size() + 1);
  }
}

}  // namespace frond
