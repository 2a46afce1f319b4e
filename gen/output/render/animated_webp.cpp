#include "render/animated_webp.h"

#include <fmt/format.h>
#include <webp/demux.h>
#include <webp/encode.h>
#include <webp/mux.h>

#include <cmath>
#include <memory>
#include <utility>

#include "core/printable.h"
#include "core/read_as.h"
#include "images/raster.h"
#include "render/place.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

constexpr float kQuality = 80;  // of 100, somewhat above the 75 that libwebp takes by itself

template <auto free>
struct Freed {
  template <class Thing>
  void operator()(Thing* thing) const {
    free(thing);
  }
};

WebPData data_of(const std::string& bytes) {
  return {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
}

/// Title and comment by the words of Dublin Core, as XMP of pictures has them.
std::string xmp_of(const std::string& title, const std::string& comment) {
  auto told = [](std::string_view name, const std::string& text) {
    return fmt::format(R"(<dc:{0}><rdf:Alt><rdf:li xml:lang="x-default">{1}</rdf:li></rdf:Alt></dc:{0}>)",
                       name, xml_quoted(text));
  };
  return fmt::format(
      R"(<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#">)"
      R"(<rdf:Description rdf:about="" xmlns:dc="http://purl.org/dc/elements/1.1/">{}{}</rdf:Description>)"
      R"(</rdf:RDF></x:xmpmeta>)",
      told("title", title), told("description", comment));
}

using Mux = std::unique_ptr<WebPMux, Freed<WebPMuxDelete>>;

/// A film of one picture for so many milliseconds. libwebp makes stills of pictures that are all alike, and
/// of a film of one frame; so this one has two.
Mux shown_for(int milliseconds, const WebPData& picture) {
  Mux mux(WebPMuxNew());
  WebPMuxAnimParams played{};
  bool made = mux && WebPMuxSetAnimationParams(mux.get(), &played) == WEBP_MUX_OK;
  for (int part : {milliseconds / 2, milliseconds - milliseconds / 2}) {
    WebPMuxFrameInfo frame{};
    frame.bitstream = picture, frame.duration = part, frame.id = WEBP_CHUNK_ANMF;
    made = made && WebPMuxPushFrame(mux.get(), &frame, 1) == WEBP_MUX_OK;
  }
  return made ? std::move(mux) : nullptr;
}

class Encoder {
 public:
  /// Shows a picture from that millisecond on; what is wrong, if something is.
  std::string add(const Raster& raster, int from) {
    if (!encoder_) encoder_.reset(WebPAnimEncoderNew(raster.width, raster.height, nullptr));
    WebPConfig config;
    WebPPicture picture;
    if (!encoder_ || !WebPConfigPreset(&config, WEBP_PRESET_PHOTO, kQuality) || !WebPPictureInit(&picture))
      return "libwebp refuses to encode";
    std::unique_ptr<WebPPicture, Freed<WebPPictureFree>> freed(&picture);
    picture.width = raster.width, picture.height = raster.height, picture.use_argb = 1;
    auto import = raster.channels == 4 ? &WebPPictureImportRGBA : &WebPPictureImportRGB;
    if (!import(&picture, raster.data.data(), raster.width * raster.channels) ||
        !WebPAnimEncoderAdd(encoder_.get(), &picture, from, &config))
      return failure();
    return {};
  }

  /// The film, whose last picture ends at that millisecond; empty where there is none.
  std::string film(int end, const std::string& xmp) {
    WebPData bytes{};
    std::unique_ptr<WebPData, Freed<WebPDataClear>> freed(&bytes);
    if (!WebPAnimEncoderAdd(encoder_.get(), nullptr, end, nullptr) ||
        !WebPAnimEncoderAssemble(encoder_.get(), &bytes))
      return {};
    Mux mux(WebPMuxCreate(&bytes, 1));
    std::uint32_t features = 0;
    if (mux && WebPMuxGetFeatures(mux.get(), &features) == WEBP_MUX_OK && !(features & ANIMATION_FLAG))
      mux = shown_for(end, bytes);
    WebPData told = data_of(xmp), whole{};
    std::unique_ptr<WebPData, Freed<WebPDataClear>> also(&whole);
    if (!mux || WebPMuxSetChunk(mux.get(), "XMP ", &told, 1) != WEBP_MUX_OK ||
        WebPMuxAssemble(mux.get(), &whole) != WEBP_MUX_OK)
      return {};
    return {reinterpret_cast<const char*>(whole.bytes), whole.size};
  }

  std::string failure() {
    return encoder_ ? WebPAnimEncoderGetError(encoder_.get()) : "there are no pictures";
  }

 private:
  std::unique_ptr<WebPAnimEncoder, Freed<WebPAnimEncoderDelete>> encoder_;
};

}  // namespace

Result<std::string> animated_webp(const std::vector<fs::path>& pictures, const std::string& fps,
                                  const std::string& title, const std::string& comment) {
  double rate = read_as<double>(fps).value_or(24);
  auto begins = [&](std::size_t frame) {
    return static_cast<int>(std::lround(1000 * static_cast<double>(frame) / rate));
  };
  Encoder encoder;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    Result<std::string> bytes = whole_picture(pictures[i]);
    Result<Raster> raster = bytes ? read_png(*bytes) : bytes.errors();
    if (!raster) return raster.errors();
    if (raster->channels == 1) return Error{pictures[i].string(), "is grey; expected a frame of a film"};
    if (std::string wrong = encoder.add(*raster, begins(i)); !wrong.empty())
      return Error{pictures[i].string(), wrong};
  }
  std::string film = encoder.film(begins(pictures.size()), xmp_of(title, comment));
  if (film.empty()) return Error{"", encoder.failure()};
  return film;
}

int milliseconds_in_webp(const std::string& bytes) {
  WebPData data = data_of(bytes);
  std::unique_ptr<WebPDemuxer, Freed<WebPDemuxDelete>> demuxer(WebPDemux(&data));
  WebPIterator frame;
  if (!demuxer || !WebPDemuxGetFrame(demuxer.get(), 1, &frame)) return 0;
  int sum = 0;
  do sum += frame.duration;
  while (WebPDemuxNextFrame(&frame));
  WebPDemuxReleaseIterator(&frame);
  return sum;
}

}  // namespace frond
