// What a folder is, given as a source: the one dataset in it.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <functional>

namespace wakesurf::importer {

/// A file that lists others (.pvd, .series, .case) goes before the files it may list; else the one file or numbered
/// series there is. Files that `readable` does not know do not count. Error: NotFound (nothing to read),
/// InvalidArgument (several datasets, listed), Io.
core::Result<std::filesystem::path>
choose_in_folder(const std::filesystem::path& folder,
                 const std::function<bool(const std::filesystem::path&)>& readable);

} // namespace wakesurf::importer
