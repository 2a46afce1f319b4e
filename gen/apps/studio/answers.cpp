#include "studio/answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "core/content.h"
#include "grammar/symbols.h"
#include "preset/keys.h"
#include "scene/describe.h"

namespace frond {

namespace {

constexpr int kSmallest = 16, kLargest = 8192;  // pixels of a side
constexpr std::int64_t kMostEntries = 1'000'000'000;

}  // namespace

Answer wrong(const Errors& errors, const Errors& notes) {
  return {422, {{"errors", errors_json(errors)}, {"notes", errors_json(notes)}}};
}

std::string key_of(const Doc& doc, const Preset& preset) {
  return content_id(doc.file.string() + keys_of(preset).all());
}

std::string reason_of(const std::exception_ptr& error) {
  try {
    std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
    return "there is not enough memory for that";
  } catch (const Json::exception&) {
    return "a value is not of the type that is expected";
  } catch (const std::exception& thrown) {
    return thrown.what();
  } catch (...) {
    return "something that is no exception";
  }
}

Answer fault_answer(const std::exception_ptr& error) {
  int status = 500;
  try {
    std::rethrow_exception(error);
  } catch (const Json::exception&) {
    status = 400;
  } catch (const WrongQuestion&) {
    status = 400;
  } catch (...) {
  }
  return refused(status, reason_of(error));
}

double number(const Json& value, const char* name, double least, double most) {
  // What is no number compares as no number does.
  double x = value.is_number() ? value.get<double>() : std::nan("");
  if (x >= least && x <= most) return x;
  throw WrongQuestion(fmt::format("{}: expected a number from {} to {}", name, least, most));
}

std::int64_t whole_number(const Json& value, const char* name, std::int64_t least, std::int64_t most) {
  // Doubles hold every whole number that is asked for.
  double x = value.is_number() ? value.get<double>() : std::nan("");
  if (x == std::floor(x) && x >= static_cast<double>(least) && x <= static_cast<double>(most))
    return static_cast<std::int64_t>(x);
  throw WrongQuestion(fmt::format("{}: expected a whole number from {} to {}", name, least, most));
}

double number_in(const Json& question, const char* name, double otherwise, double least, double most) {
  return question.contains(name) ? number(question[name], name, least, most) : otherwise;
}

std::size_t index_in(const Json& question, const char* name, std::size_t otherwise) {
  if (!question.contains(name)) return otherwise;
  return static_cast<std::size_t>(whole_number(question[name], name, 0, kMostEntries));
}

double time_in(const Json& question) { return number_in(question, "time", 0, -kLongestFilm, kLongestFilm); }

int frame_at(const Film& film, double time) {
  return static_cast<int>(std::lround(std::clamp<double>(time * film.fps, 0, film.frames - 1))) + 1;
}

std::array<int, 2> size_in(const Json& question) {
  const Json& size = question.at("size");
  if (!size.is_array() || size.size() != 2)
    throw WrongQuestion("size: expected a width and a height in pixels");
  auto side = [&](std::size_t i) {
    return static_cast<int>(whole_number(size[i], "size", kSmallest, kLargest));
  };
  return {side(0), side(1)};
}

std::set<std::size_t> numbers(const Json& question, const char* name) {
  std::set<std::size_t> set;
  if (question.contains(name) && question[name].is_array())
    for (const Json& value : question[name])
      if (value.is_number_unsigned()) set.insert(value.get<std::size_t>());
  return set;
}

Json symbols_json() {
  Json symbols = Json::array();
  for (const TurtleSymbol& symbol : turtle_symbols())
    symbols.push_back({{"symbol", symbol.name}, {"doc", symbol.doc}});
  return symbols;
}

}  // namespace frond
