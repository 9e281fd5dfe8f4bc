// The path of a file that another file names. If confined, the author of that file cannot make the importer
// read other files of the machine: paths outside of its folder are refused.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <string>

namespace wakesurf::importer {

/// Allows, for the whole process and before its first source is opened, files anywhere that the user may
/// read, named by .., an absolute path or a link. It is for sources that the user named on a command line.
/// Until this is called, paths are confined.
void allow_paths_out_of_folder();

/// Returns a name for messages: of an absolute path, whose folders are private, the file's name only.
std::string told_name(const std::string& name);

/// Returns `folder` / `name`, without following links. Error, while paths are confined: Unsupported, if ..,
/// an absolute path or a symbolic link leads out of the folder. @param named_by  the file that names it, for
/// the message
core::Result<std::filesystem::path> named_path(const std::filesystem::path& folder,
                                               const std::string& name,
                                               const std::string& named_by);

} // namespace wakesurf::importer
