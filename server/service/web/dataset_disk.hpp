// Where the files of a dataset are: on a disk, or on the web.
#pragma once

#include "core/base/disk.hpp"
#include "core/base/result.hpp"

#include <filesystem>
#include <memory>

namespace wakesurf::server {

/// Its files are below an address that store_address() returned.
bool is_on_the_web(const std::filesystem::path& folder);

/// Opens nothing yet. Credentials are those of the environment. Error: InvalidArgument where they would go over a line that anybody
/// can read.
core::Result<std::shared_ptr<const core::Disk>> disk_of(const std::filesystem::path& folder);

} // namespace wakesurf::server
