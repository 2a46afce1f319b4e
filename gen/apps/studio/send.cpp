#include "studio/send.h"

#include <fstream>
#include <memory>

namespace frond {

namespace {

constexpr std::size_t kPiece = 256 << 10;  // bytes of a file that are sent at once

}  // namespace

void send(httplib::Response& response, Answer answer) {
  response.status = answer.status;
  if (answer.status == 204) return;
  const bool json = !answer.type;
  response.body =
      json ? answer.json.dump(-1, ' ', false, Json::error_handler_t::replace) : std::move(answer.packet);
  response.set_header("Content-Type", json ? "application/json" : answer.type);
}

void send_file(httplib::Response& response, const std::filesystem::path& path) {
  std::string ending = path.extension();
  const char* type = ending == ".png"    ? "image/png"
                     : ending == ".mov"  ? "video/quicktime"
                     : ending == ".webm" ? "video/webm"
                                         : "video/mp4";
  std::error_code error;
  auto size = std::filesystem::file_size(path, error);
  auto file = std::make_shared<std::ifstream>(path, std::ios::binary);
  if (error || !*file || size == 0) return send(response, refused(404, "the file is not there"));
  response.set_content_provider(
      size, type, [file](std::size_t at, std::size_t length, httplib::DataSink& sink) {
        std::vector<char> piece(std::min(length, kPiece));
        file->clear();
        file->seekg(static_cast<std::streamoff>(at));
        file->read(piece.data(), static_cast<std::streamsize>(piece.size()));
        return file->gcount() > 0 && sink.write(piece.data(), static_cast<std::size_t>(file->gcount()));
      });
}

}  // namespace frond
