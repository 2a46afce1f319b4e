#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"

/// Films and sheets of finished pictures, by ffmpeg. Each is seen whole or not at all; the same pictures give
/// the same bytes.
namespace frond {

/// A film: H.264 (.mp4) that plays everywhere, VP9 (.webm), ProRes 4444 (.mov) for editing, a GIF whose
/// palette is made of the whole film, or an animated WebP.
struct FilmJob {
  std::vector<std::filesystem::path> pictures;  ///< PNG, one a frame
  std::filesystem::path film;                   ///< its ending says the format; another than these is an MP4
  std::string fps = "24";                       ///< frames a second
  std::string title, comment;                   ///< for its metadata; of a GIF, a comment; of a WebP, XMP
  std::string ffmpeg = "ffmpeg";                ///< the program
  bool alpha = false;                           ///< keeps the opacity of its pictures; not in an MP4
};

/// Makes it; none where a picture is damaged. The last of the errors says so, those before it why.
Errors encode_film(const FilmJob& job);

/// Pictures of one size in rows and columns.
struct SheetJob {
  std::vector<std::filesystem::path> pictures;  ///< PNG, row by row
  std::filesystem::path sheet;                  ///< a .png
  int columns = 6;
  int width = 240;  ///< pixels, of a picture at most
  std::string ffmpeg = "ffmpeg";
};

/// A filter of ffmpeg that lays pictures of the format gbrap, whose colours are multiplied by their opacity,
/// over a chequered ground.
std::string over_checks();

/// Makes it; errors as of a film. What is transparent shows a chequered ground.
Errors tile_sheet(const SheetJob& job);

/// Copies a whole picture, which then says how many pixels an inch it has; with 0 dpi it does not.
Errors copy_picture(const std::filesystem::path& picture, const std::filesystem::path& to, double dpi = 0);

/// How many pictures a film of so many a second holds, by what is there of them and not by its header; 0
/// where there is no telling.
int frames_in(const std::filesystem::path& film, const std::string& ffmpeg, double fps);

/// A GIF with a comment behind its first table of colours, which ffmpeg does not write.
std::string gif_with_comment(std::string_view gif, std::string_view comment);

}  // namespace frond
