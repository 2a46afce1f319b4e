#pragma once

#include <cstddef>
#include <string_view>

#include "core/result.h"

namespace frond {

/// Makes sure that there are file descriptors 0 to 2, or a file that is written would take the place of one
/// that is closed and receive what is meant for it. Before all else.
void open_streams();

/// Data, to stdout. What goes wrong shows in close_out().
void put(std::string_view text);

/// Sends off what was put, for a reader that waits for it.
void flush();

/// Words for the user, to stderr, as they are; see messages.h for whole lines. Where they cannot be written
/// nothing is lost but them.
void put_words(std::string_view text);
/// How often that was done.
std::size_t words_told();

/// Writes out what stdout still holds. Empty where all that was put arrived.
Errors close_out();

/// Notes what the program is at, for the message when memory runs out; text that lives as long as the
/// program.
void now_doing(const char* what);
const char* what_is_done();

}  // namespace frond
