#include "images/png_samples.h"

#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstring>
#include <exception>

namespace frond {

namespace {

constexpr png_uint_32 kMostSide = 65'536;  // pixels

/// What libpng reads from and writes to.
struct PngBytes {
  std::string_view in;
  std::string out;
  std::string fault;
};

void png_read_bytes(png_structp png, png_bytep data, png_size_t size) {
  auto* bytes = static_cast<PngBytes*>(png_get_io_ptr(png));
  if (size > bytes->in.size()) png_error(png, "it is cut short");
  std::memcpy(data, bytes->in.data(), size);
  bytes->in.remove_prefix(size);
}

void png_write_bytes(png_structp png, png_bytep data, png_size_t size) {
  auto* bytes = static_cast<PngBytes*>(png_get_io_ptr(png));
  bool room = true;
  try {
    bytes->out.append(reinterpret_cast<const char*>(data), size);
  } catch (const std::exception&) {  // must not pass through libpng, which is C
    room = false;
  }
  if (!room) png_error(png, "there is no memory for it");
}

[[noreturn]] void png_fail(png_structp png, png_const_charp what) {
  static_cast<PngBytes*>(png_get_error_ptr(png))->fault = what;
  png_longjmp(png, 1);
}

void png_ignore(png_structp, png_const_charp) {}

/// What a file says of its samples.
void read_head(png_structp png, png_infop info, PngSamples& samples) {
  png_read_info(png, info);
  if (png_get_color_type(png, info) == PNG_COLOR_TYPE_PALETTE || png_get_bit_depth(png, info) < 8)
    png_error(png, "its samples are none of 8 or 16 bits");
  samples.width = static_cast<int>(png_get_image_width(png, info));
  samples.height = static_cast<int>(png_get_image_height(png, info));
  samples.channels = png_get_channels(png, info);
  samples.bits = png_get_bit_depth(png, info);
  png_fixed_point gamma = 0;
  png_get_gAMA_fixed(png, info, &gamma);
  samples.gamma = gamma;
}

/// Into data that have room for them.
void read_rows(png_structp png, png_infop info, PngSamples& samples) {
  int passes = png_set_interlace_handling(png);
  png_read_update_info(png, info);
  for (int pass = 0; pass < passes; ++pass)
    for (int y = 0; y < samples.height; ++y)
      png_read_row(png, samples.data.data() + samples.row() * static_cast<std::size_t>(y), nullptr);
  png_read_end(png, nullptr);
}

void write_rows(png_structp png, png_infop info, const PngSamples& samples) {
  constexpr int kTypes[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                            PNG_COLOR_TYPE_RGB_ALPHA};
  png_set_IHDR(png, info, static_cast<png_uint_32>(samples.width), static_cast<png_uint_32>(samples.height),
               samples.bits, kTypes[samples.channels - 1], PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  if (samples.gamma > 0) png_set_gAMA_fixed(png, info, samples.gamma);
  png_write_info(png, info);
  for (int y = 0; y < samples.height; ++y)
    png_write_row(png, samples.data.data() + samples.row() * static_cast<std::size_t>(y));
  png_write_end(png, nullptr);
}

/// libpng's structs for a file that is read or written, which go with this, whatever is thrown.
struct PngReader {
  png_structp png;
  png_infop info = nullptr;

  explicit PngReader(PngBytes& bytes)
      : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &bytes, png_fail, png_ignore)) {
    if (!png || !(info = png_create_info_struct(png))) return;
    png_set_user_limits(png, kMostSide, kMostSide);
    png_set_read_fn(png, &bytes, png_read_bytes);
  }
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
};
struct PngWriter {
  png_structp png;
  png_infop info = nullptr;

  explicit PngWriter(PngBytes& bytes)
      : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &bytes, png_fail, png_ignore)) {
    if (!png || !(info = png_create_info_struct(png))) return;
    png_set_user_limits(png, kMostSide, kMostSide);
    png_set_write_fn(png, &bytes, png_write_bytes, nullptr);
  }
  ~PngWriter() { png_destroy_write_struct(&png, &info); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;
};

/// Whether work with libpng comes to its end. An error of libpng jumps here, over frames of C and of `work`,
/// which own nothing; no local of this one changes.
template <class Samples>
bool runs(png_structp png, png_infop info, Samples& samples, void (*work)(png_structp, png_infop, Samples&)) {
  if (!info || setjmp(png_jmpbuf(png)) != 0) return false;
  work(png, info, samples);
  return true;
}

/// Whether a file is long enough for its samples: DEFLATE makes nothing 1032 times as short.
bool may_hold(std::string_view png, const PngSamples& samples) {
  constexpr std::size_t kMostPacked = 1040;
  return samples.row() * static_cast<std::size_t>(samples.height) / kMostPacked <= png.size();
}

}  // namespace

void PngSamples::set16(std::size_t i, double share) {
  auto value = static_cast<unsigned>(std::lround(std::clamp(share, 0.0, 1.0) * 65535));
  data[2 * i] = static_cast<std::uint8_t>(value >> 8);
  data[2 * i + 1] = static_cast<std::uint8_t>(value & 0xff);
}

Result<PngSamples> read_samples(std::string_view png) {
  PngBytes bytes{png, {}, {}};
  PngSamples samples;
  PngReader reader(bytes);
  bool good = runs(reader.png, reader.info, samples, read_head);
  if (good && !may_hold(png, samples)) bytes.fault = "it is too short for its size", good = false;
  if (good) {
    samples.data.resize(samples.row() * static_cast<std::size_t>(samples.height));
    good = runs(reader.png, reader.info, samples, read_rows);
  }
  if (!good) return Error{"", "no PNG: " + bytes.fault};
  return samples;
}

Result<std::string> samples_text(const PngSamples& samples) {
  PngBytes bytes;
  PngWriter writer(bytes);
  if (!runs(writer.png, writer.info, samples, write_rows)) return Error{"", "PNG: " + bytes.fault};
  return std::move(bytes.out);
}

PngSamples cut(const PngSamples& whole, int x, int y, int width, int height) {
  PngSamples part = whole;
  part.width = width, part.height = height;
  part.data.clear();
  for (int row = y; row < y + height; ++row) {
    auto from = whole.data.begin() + static_cast<std::ptrdiff_t>(whole.row() * static_cast<std::size_t>(row) +
                                                                 whole.pixel() * static_cast<std::size_t>(x));
    part.data.insert(part.data.end(), from, from + static_cast<std::ptrdiff_t>(part.row()));
  }
  return part;
}

std::string with_density(std::string_view png, double dpi) {
  constexpr std::size_t kHead = 8 + 25;  // signature and IHDR
  constexpr double kInch = 0.0254;       // metres
  auto number = [](std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
    return bytes;
  };
  std::string dots = number(static_cast<std::uint32_t>(std::lround(dpi / kInch)));
  std::string named = "pHYs" + dots + dots + '\1';  // a metre
  auto sum = crc32(0, reinterpret_cast<const Bytef*>(named.data()), static_cast<uInt>(named.size()));
  std::string chunk = number(9) + named + number(static_cast<std::uint32_t>(sum));
  return std::string(png.substr(0, kHead)) + chunk + std::string(png.substr(std::min(kHead, png.size())));
}

}  // namespace frond
