#include "images/raster.h"

#include <png.h>

namespace frond {

namespace {

constexpr png_uint_32 kLongestSide = 16384;
constexpr std::uint64_t kMostPixels = 100'000'000;
constexpr png_uint_32 kLongestLight = 32768;  // of pictures of our own, of which one may be a raw still
constexpr std::uint64_t kMostLight = std::uint64_t{16384} * 16384;

png_uint_32 format_of(int channels) {
  return channels == 1 ? PNG_FORMAT_GRAY : channels == 3 ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
}

}  // namespace

Result<std::string> png_text(const Raster& raster) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(raster.width);
  image.height = static_cast<png_uint_32>(raster.height);
  image.format = format_of(raster.channels);
  png_alloc_size_t size = 0;
  if (!png_image_write_to_memory(&image, nullptr, &size, 0, raster.data.data(), 0, nullptr))
    return Error{"", std::string("PNG: ") + image.message};
  std::string text(size, '\0');
  if (!png_image_write_to_memory(&image, text.data(), &size, 0, raster.data.data(), 0, nullptr))
    return Error{"", std::string("PNG: ") + image.message};
  text.resize(size);
  return text;
}

namespace {

/// What libpng holds while a file is read, which goes with this, whatever is thrown.
struct ReadImage {
  png_image image{};

  ReadImage() = default;
  ~ReadImage() { png_image_free(&image); }
  ReadImage(const ReadImage&) = delete;
  ReadImage& operator=(const ReadImage&) = delete;
};

/// Begins to read a file and looks at its size.
Errors begin(png_image& image, std::string_view bytes, png_uint_32 longest, std::uint64_t most) {
  image.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()))
    return {Error{"", std::string("no PNG: ") + image.message}};
  if (image.width <= longest && image.height <= longest && std::uint64_t{image.width} * image.height <= most)
    return {};
  return {error_at("", "the picture is larger than {} pixels a side, or {} million in all", longest,
                   most / 1'000'000)};
}

/// Reads the rest, as `image.format` says.
Errors finish(png_image& image, void* data) {
  if (png_image_finish_read(&image, nullptr, data, 0, nullptr)) return {};
  return {Error{"", std::string("no PNG: ") + image.message}};
}

}  // namespace

Result<std::array<int, 2>> png_size(std::string_view bytes) {
  ReadImage read;
  if (Errors errors = begin(read.image, bytes, UINT32_MAX, UINT64_MAX); !errors.empty()) return errors;
  return std::array{static_cast<int>(read.image.width), static_cast<int>(read.image.height)};
}

Result<Raster> read_png(std::string_view bytes) {
  ReadImage read;
  png_image& image = read.image;
  if (Errors errors = begin(image, bytes, kLongestSide, kMostPixels); !errors.empty()) return errors;
  bool color = image.format & PNG_FORMAT_FLAG_COLOR, alpha = image.format & PNG_FORMAT_FLAG_ALPHA;
  int channels = alpha ? 4 : color ? 3 : 1;
  image.format = format_of(channels);
  Raster raster(static_cast<int>(image.width), static_cast<int>(image.height), channels);
  if (Errors errors = finish(image, raster.data.data()); !errors.empty()) return errors;
  return raster;
}

Result<LinearRaster> read_linear_png(std::string_view bytes, bool opacity) {
  ReadImage read;
  png_image& image = read.image;
  if (Errors errors = begin(image, bytes, kLongestLight, kMostLight); !errors.empty()) return errors;
  bool alpha = opacity && image.format & PNG_FORMAT_FLAG_ALPHA;
  image.format = alpha ? PNG_FORMAT_LINEAR_RGB_ALPHA : PNG_FORMAT_LINEAR_RGB;
  LinearRaster raster{static_cast<int>(image.width), static_cast<int>(image.height), alpha ? 4 : 3, {}};
  raster.data.resize(static_cast<std::size_t>(raster.channels) * image.width * image.height);
  if (Errors errors = finish(image, raster.data.data()); !errors.empty()) return errors;
  return raster;
}

}  // namespace frond
