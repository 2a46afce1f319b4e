#pragma once

#include <array>
#include <cstdint>
#include <exception>
#include <set>
#include <stdexcept>
#include <string>

#include "studio/documents.h"

namespace frond {

/// The answer that a preset is wrong.
Answer wrong(const Errors& errors, const Errors& notes = {});

/// All that a scene follows from, and whose it is.
std::string key_of(const Doc& doc, const Preset& preset);

/// What an answer says of an exception that ended it.
std::string reason_of(const std::exception_ptr& error);

/// The answer to a question that ended so: 400 where the question is at fault.
Answer fault_answer(const std::exception_ptr& error);

/// A question that asks for what cannot be. Answered by 400 and its text.
struct WrongQuestion : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Numbers of a question, which has to hold them: throws a WrongQuestion where there is no such number, it is
/// not whole or not within the range. No number ever becomes another one.
double number(const Json& value, const char* name, double least, double most);
std::int64_t whole_number(const Json& value, const char* name, std::int64_t least, std::int64_t most);
/// Numbers of a member of a question, `otherwise` where it is missing; as above, a wrong one throws a
/// WrongQuestion.
double number_in(const Json& question, const char* name, double otherwise, double least, double most);
std::size_t index_in(const Json& question, const char* name, std::size_t otherwise);

/// Seconds of a film that a question asks about, 0 where it does not say; at most kLongestFilm either way.
inline constexpr double kLongestFilm = 1e7;
double time_in(const Json& question);
/// The frame of a film at a time, from 1.
int frame_at(const Film& film, double time);

/// Width and height of a picture in pixels.
std::array<int, 2> size_in(const Json& question);

/// The whole numbers of a list of a question; none where there is no such list.
std::set<std::size_t> numbers(const Json& question, const char* name);

/// `[{"symbol", "doc"}, …]` of all symbols of the turtle.
Json symbols_json();

}  // namespace frond
