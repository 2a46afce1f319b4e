#include "images/read_picture.h"

#include <turbojpeg.h>
#include <webp/decode.h>

#include <memory>

#include "images/picture_turn.h"

namespace frond {

namespace {

constexpr int kMostSidePixels = 16384;
constexpr double kMostInAll = 100e6;

const unsigned char* first_byte(std::string_view bytes) {
  return reinterpret_cast<const unsigned char*>(bytes.data());
}

Errors refuse_large(int width, int height) {
  if (width <= kMostSidePixels && height <= kMostSidePixels && 1.0 * width * height <= kMostInAll) return {};
  return {Error{"", "the picture is larger than 16384 pixels a side, or 100 million in all"}};
}

struct CloseJpeg {
  void operator()(void* reader) const { tjDestroy(reader); }
};

Result<Raster> read_jpeg(std::string_view bytes, bool upright) {
  std::unique_ptr<void, CloseJpeg> reader(tjInitDecompress());
  int width = 0, height = 0, sampling = 0, colors = 0;
  if (tjDecompressHeader3(reader.get(), first_byte(bytes), bytes.size(), &width, &height, &sampling, &colors))
    return error_at("", "is a damaged JPEG: {}", tjGetErrorStr2(reader.get()));
  if (Errors errors = refuse_large(width, height); !errors.empty()) return errors;
  if (colors == TJCS_CMYK || colors == TJCS_YCCK)
    return Error{"", "is a JPEG for print, in CMYK; expected one in RGB"};
  Raster raster(width, height, colors == TJCS_GRAY ? 1 : 3);
  int failed = tjDecompress2(reader.get(), first_byte(bytes), bytes.size(), raster.data.data(), width, 0,
                             height, raster.channels == 1 ? TJPF_GRAY : TJPF_RGB, TJFLAG_ACCURATEDCT);
  // Cameras write bytes that the library warns of; what ends too early lacks a part of the picture.
  std::string_view said = failed ? tjGetErrorStr2(reader.get()) : "";
  if (failed && (tjGetErrorCode(reader.get()) != TJERR_WARNING || said.find("Premature") != said.npos))
    return error_at("", "is a damaged JPEG: {}", said);
  return upright ? turned(raster, jpeg_turn(bytes)) : raster;
}

Result<Raster> read_webp(std::string_view bytes) {
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(first_byte(bytes), bytes.size(), &features) != VP8_STATUS_OK)
    return Error{"", "is a damaged WebP"};
  if (features.has_animation) return Error{"", "is a WebP that moves; expected one picture"};
  if (Errors errors = refuse_large(features.width, features.height); !errors.empty()) return errors;
  Raster raster(features.width, features.height, features.has_alpha ? 4 : 3);
  auto decode = features.has_alpha ? &WebPDecodeRGBAInto : &WebPDecodeRGBInto;
  if (!decode(first_byte(bytes), bytes.size(), raster.data.data(), raster.data.size(),
              raster.width * raster.channels))
    return Error{"", "is a damaged WebP"};
  return turned(raster, webp_turn(bytes));
}

/// What a file is that is none of these, by its first bytes.
std::string_view said_kind(std::string_view bytes) {
  std::string_view brand = bytes.size() > 12 && bytes.substr(4, 4) == "ftyp" ? bytes.substr(8, 4) : "";
  if (brand == "avif") return "is an AVIF picture";
  if (brand == "heic" || brand == "heix" || brand == "mif1" || brand == "msf1") return "is a HEIC picture";
  if (bytes.starts_with("GIF8")) return "is a GIF picture";
  if (bytes.starts_with("BM")) return "is a BMP picture";
  if (bytes.starts_with(std::string_view("II*\0", 4)) || bytes.starts_with(std::string_view("MM\0*", 4)))
    return "is a TIFF picture, or the raw one of a camera";
  return "is no picture that Frond reads";
}

bool is_png(std::string_view bytes) { return bytes.starts_with("\x89PNG"); }
bool is_jpeg(std::string_view bytes) { return bytes.starts_with("\xff\xd8\xff"); }
bool is_webp(std::string_view bytes) {
  return bytes.starts_with("RIFF") && bytes.size() > 12 && bytes.substr(8, 4) == "WEBP";
}

Result<Raster> read(std::string_view bytes, bool upright) {
  if (is_png(bytes)) return read_png(bytes);
  if (is_jpeg(bytes)) return read_jpeg(bytes, upright);
  if (is_webp(bytes)) return read_webp(bytes);
  return error_at("", "{}; expected a PNG, JPEG or WebP file", said_kind(bytes));
}

}  // namespace

Result<Raster> read_picture(std::string_view bytes) { return read(bytes, true); }

Result<Raster> read_texture(std::string_view bytes) { return read(bytes, false); }

bool is_picture(std::string_view bytes) { return is_png(bytes) || is_jpeg(bytes) || is_webp(bytes); }

}  // namespace frond
