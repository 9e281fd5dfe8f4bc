// The location of a dataset's files: a disk, or the web.
#pragma once

#include "core/base/disk.hpp"
#include "core/base/result.hpp"

#include <filesystem>
#include <memory>
#include <stop_token>

namespace wakesurf::server {

/// Says whether the files are below an address that store_address() returned.
bool is_on_the_web(const std::filesystem::path& folder);

/// Returns the disk; opens nothing yet. Credentials are those of the environment. Error: InvalidArgument if
/// they would be sent unencrypted, or hold a line break. @param closing  ends all questions to a web server
core::Result<std::shared_ptr<const core::Disk>> disk_of(const std::filesystem::path& folder,
                                                        std::stop_token closing = {});

} // namespace wakesurf::server
