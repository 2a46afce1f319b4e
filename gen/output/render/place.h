#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/result.h"

/// Files that are seen whole or not at all, and pictures that are told to be whole.
namespace frond {

/// The name of what is to become a file, beside it: `.film.mp4.part`. Nothing is there any more: a link would
/// be written through.
std::filesystem::path part_of(const std::filesystem::path& file);

/// Renames a finished file once it lies on the disk, so that not even a crash leaves half of it; a link in
/// its place is replaced, a folder there is an error.
Errors put_in_place(const std::filesystem::path& part, const std::filesystem::path& file);

/// Writes a text as `part` and puts it in the place of the file, which is new then even if it held the same.
Errors put_text(const std::filesystem::path& part, const std::filesystem::path& file, std::string_view text);

/// What a file holds that is a whole picture (PNG, every chunk with its sum) and, unless that is 0 by 0, of
/// that size; else why it is none.
Result<std::string> whole_picture(const std::filesystem::path& file, std::array<int, 2> size = {});

/// A whole PNG without what stands in front of its pixels of time and text: POV-Ray writes the hour there.
std::string without_time(std::string_view png);

/// WIDTHxHEIGHT as two numbers, or 0 by 0.
std::array<int, 2> size_of(std::string_view text);

}  // namespace frond
