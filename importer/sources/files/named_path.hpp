// The path of a file that another file names. Confined, the author of that file cannot have other files of the machine read:
// what lies outside of its folder is refused.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <string>

namespace wakesurf::importer {

/// For the whole process, before its first source is opened: files may be named anywhere that the user may read, as by .., an
/// absolute path or a link. That is for sources that the user named on a command line. Until this is called, paths are confined.
void allow_paths_out_of_folder();

/// What people are told of a name: of an absolute path, whose folders are no one else's business, the file's name only.
std::string told_name(const std::string& name);

/// `folder` / `name`, without following it. Error, while paths are confined: Unsupported, where .., an absolute path or a symbolic
/// link leads out of the folder. @param named_by  the file that names it, for the message
core::Result<std::filesystem::path> named_path(const std::filesystem::path& folder,
                                               const std::string& name,
                                               const std::string& named_by);

} // namespace wakesurf::importer
