#pragma once

#include <filesystem>

#include "studio/connections.h"
#include "studio/scenes.h"

/// What the studio answers, as HTTP has it.
namespace frond {

void send(httplib::Response& response, Answer answer);
/// A file piece by piece, of which a player may ask for any part; 404 where it is not there.
void send_file(httplib::Response& response, const std::filesystem::path& path);

}  // namespace frond
