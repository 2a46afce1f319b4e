#pragma once

#include <string_view>

namespace frond {

/// Whether people look at stderr on a terminal, where lines can be drawn anew.
bool on_terminal();

/// Draws a bar and words on the current line of the terminal.
void draw_bar(int done, int all, std::string_view words);

/// Clears the bar, if one stands there.
void end_bar();

/// A whole line, in place of the bar.
void say(std::string_view line);

}  // namespace frond
