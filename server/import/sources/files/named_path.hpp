// The path of a file that another file names. The author of that file must not have other files of the machine read: what
// lies outside of its folder is refused.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <string>

namespace wakesurf::server {

/// `folder` / `name`, without following it. Error: Unsupported, where .., an absolute path or a symbolic link leads out of
/// the folder. @param named_by  the file that names it, for the message
core::Result<std::filesystem::path> named_path(const std::filesystem::path& folder,
                                               const std::string& name,
                                               const std::string& named_by);

} // namespace wakesurf::server
