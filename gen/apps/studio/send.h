#pragma once

#include <filesystem>

#include "studio/connections.h"
#include "studio/scenes.h"

/// What the studio answers, as HTTP has it.
namespace frond {

void send(httplib::Response& response, int status, const Json& json);
void send(httplib::Response& response, Answer answer);
/// 404 where there is none.
void send_picture(httplib::Response& response, const Result<std::string>& picture, const char* type);
/// A file piece by piece, of which a player may ask for any part; 404 where it is not there.
void send_file(httplib::Response& response, const std::filesystem::path& path);

}  // namespace frond
