#include "images/png_rows.h"

#include <png.h>

#include <algorithm>
#include <cassert>
#include <csetjmp>
#include <cstring>
#include <exception>

namespace frond {

namespace {

// libpng leaves its functions by a jump where something is wrong: each call below stands in a function of its
// own, which holds nothing that would have to be cleaned up and changes no local.

[[noreturn]] void png_fail(png_structp png, png_const_charp what) {
  *static_cast<std::string*>(png_get_error_ptr(png)) = what;
  png_longjmp(png, 1);
}

void png_ignore(png_structp, png_const_charp) {}

/// Whether a file is long enough for its samples: DEFLATE makes nothing 1032 times as short.
bool may_hold(std::size_t bytes, const PngSamples& head) {
  constexpr std::size_t kMostPacked = 1040;
  return head.row() * static_cast<std::size_t>(head.height) / kMostPacked <= bytes;
}

}  // namespace

struct PngRows::Reader {
  std::string_view left;
  std::string fault;
  png_structp png = nullptr;
  png_infop info = nullptr;
  PngSamples head;  // without data
  int done = 0;
  int passes = 1;  // over the rows, of which an interlaced picture has seven

  explicit Reader(std::string_view bytes) : left(bytes) {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &fault, png_fail, png_ignore);
    if (png) info = png_create_info_struct(png);
  }
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  static void read_bytes(png_structp png, png_bytep data, png_size_t size) {
    auto& left = *static_cast<std::string_view*>(png_get_io_ptr(png));
    if (size > left.size()) png_error(png, "it is cut short");
    std::memcpy(data, left.data(), size);
    left.remove_prefix(size);
  }

  bool read_head() {
    if (!info || setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_read_fn(png, &left, read_bytes);
    png_set_user_limits(png, kLongestRow, kLongestRow);
    png_read_info(png, info);
    if (png_get_color_type(png, info) == PNG_COLOR_TYPE_PALETTE || png_get_bit_depth(png, info) < 8)
      png_error(png, "its samples are none of 8 or 16 bits");
    head.width = static_cast<int>(png_get_image_width(png, info));
    head.height = static_cast<int>(png_get_image_height(png, info));
    head.channels = png_get_channels(png, info);
    head.bits = png_get_bit_depth(png, info);
    passes = png_set_interlace_handling(png);
    png_fixed_point gamma = 0;
    png_get_gAMA_fixed(png, info, &gamma);
    head.gamma = gamma;
    png_read_update_info(png, info);
    return true;
  }

  bool read_rows(std::uint8_t* to, std::size_t row, int rows) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    for (int pass = 0; pass < passes; ++pass)
      for (int y = 0; y < rows; ++y) png_read_row(png, to + row * static_cast<std::size_t>(y), nullptr);
    return true;
  }

  bool read_end() {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_read_end(png, nullptr);
    return true;
  }

  Error error() const { return {"", "no PNG: " + fault}; }
};

PngRows::PngRows(std::unique_ptr<Reader> reader) : reader_(std::move(reader)) {}
PngRows::PngRows(PngRows&&) noexcept = default;
PngRows& PngRows::operator=(PngRows&&) noexcept = default;
PngRows::~PngRows() = default;

Result<PngRows> PngRows::open(std::string_view png) {
  auto reader = std::make_unique<Reader>(png);
  if (!reader->read_head()) return reader->error();
  if (!may_hold(png.size(), reader->head)) return Error{"", "no PNG: it is too short for its size"};
  return PngRows(std::move(reader));
}

int PngRows::width() const { return reader_->head.width; }
int PngRows::height() const { return reader_->head.height; }
int PngRows::channels() const { return reader_->head.channels; }
int PngRows::done() const { return reader_->done; }

Result<PngSamples> PngRows::next(int rows) {
  assert(rows >= 0 && rows <= height() - reader_->done);
  if (reader_->passes > 1 && rows != height())
    return Error{"", "the picture is interlaced; expected rows from the top down"};
  PngSamples band = reader_->head;
  band.height = rows;
  band.data.resize(band.row() * static_cast<std::size_t>(rows));
  if (!reader_->read_rows(band.data.data(), band.row(), rows)) return reader_->error();
  reader_->done += rows;
  if (reader_->done == height() && !reader_->read_end()) return reader_->error();
  return band;
}

Result<LinearRaster> PngRows::next_linear(int rows, bool opacity) {
  Result<PngSamples> band = next(rows);
  if (!band) return band.errors();
  // As a picture of its own, so that it is taken to light just as a whole one is.
  PngWriter writer(*band);
  writer.add(*band);
  Result<std::string> bytes = writer.finish();
  return bytes ? read_linear_png(*bytes, opacity) : bytes.errors();
}

struct PngWriter::Writer {
  std::string out;
  std::string fault;
  png_structp png = nullptr;
  png_infop info = nullptr;

  Writer() {
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &fault, png_fail, png_ignore);
    if (png) info = png_create_info_struct(png);
  }
  ~Writer() { png_destroy_write_struct(&png, &info); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  static void give(png_structp png, png_bytep data, png_size_t size) {
    bool room = true;
    try {
      static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
    } catch (const std::exception&) {  // must not pass through libpng, which is C
      room = false;
    }
    if (!room) png_error(png, "there is no memory for it");
  }

  bool write_head(const PngSamples& like, int compression) {
    constexpr int kTypes[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB,
                              PNG_COLOR_TYPE_RGB_ALPHA};
    if (!info || setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_write_fn(png, &out, give, nullptr);
    png_set_user_limits(png, kLongestRow, kLongestRow);
    png_set_compression_level(png, compression);
    png_set_IHDR(png, info, static_cast<png_uint_32>(like.width), static_cast<png_uint_32>(like.height),
                 like.bits, kTypes[like.channels - 1], PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (like.gamma > 0) png_set_gAMA_fixed(png, info, like.gamma);
    png_write_info(png, info);
    return true;
  }

  bool write_rows(const std::uint8_t* from, std::size_t row, int rows) {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    for (int y = 0; y < rows; ++y) png_write_row(png, from + row * static_cast<std::size_t>(y));
    return true;
  }

  bool write_end() {
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_write_end(png, nullptr);
    return true;
  }
};

PngWriter::PngWriter(const PngSamples& like, int compression) : writer_(std::make_unique<Writer>()) {
  if (!writer_->write_head(like, compression) && writer_->fault.empty())
    writer_->fault = "there is no memory for it";
}
PngWriter::PngWriter(PngWriter&&) noexcept = default;
PngWriter& PngWriter::operator=(PngWriter&&) noexcept = default;
PngWriter::~PngWriter() = default;

void PngWriter::add(const PngSamples& rows) {
  if (writer_->fault.empty()) writer_->write_rows(rows.data.data(), rows.row(), rows.height);
}

Result<std::string> PngWriter::finish() {
  if (!writer_->fault.empty() || !writer_->write_end()) return Error{"", "PNG: " + writer_->fault};
  return std::move(writer_->out);
}

}  // namespace frond
