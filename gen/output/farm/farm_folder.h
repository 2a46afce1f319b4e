#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"
#include "render/process.h"

/// The folder of a film that a farm renders. All that its pictures depend on, this tool among it, is copied
/// there, and it is named by it: a preset that is edited or a tool that is built anew while the film renders
/// changes nothing, and another film is another folder.
///
///     FOLDER/call             how the film was asked for
///     FOLDER/tool, files      the copies; files under the paths where they were
///     FOLDER/frames, models   what tasks have made
///     FOLDER/log, failed      what they have said, and what of what could not be made
namespace frond {

/// How a film was asked for.
struct FarmCall {
  std::filesystem::path folder, preset;  ///< where the call was made, and the preset; both from the root on
  std::filesystem::path assets;          ///< the same, or empty
  std::vector<std::string> options;      ///< of `frond generate`

  /// The words one after the other, each ended by a zero.
  std::string text() const;
};

/// That of a job.
Result<FarmCall> read_farm_call(const std::filesystem::path& job);

/// Has the copy of this program generate into a folder from the copies of a job's files, as the film was
/// asked for, and as `options` say besides.
Command generate_command(const std::filesystem::path& job, const FarmCall& call,
                         const std::filesystem::path& out, const std::vector<std::string>& options);

/// Copies what a call depends on, `program` and these files of the preset, to FARM/HASH, unless that is there
/// already, and has FARM/latest lead there. Nothing is written through a link. A signal shows in `stop`, and
/// ends it with an error.
Result<std::filesystem::path> make_farm_folder(const std::filesystem::path& farm, const FarmCall& call,
                                               const std::filesystem::path& program,
                                               const std::vector<std::filesystem::path>& files, Stop& stop);

}  // namespace frond
