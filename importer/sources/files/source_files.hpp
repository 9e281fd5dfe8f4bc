// The files a source is made of, by what they are called for people, and their state for deciding whether an import
// of them is still good.
#pragma once

#include "core/base/result.hpp"
#include "store/store_manifest.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace wakesurf::importer {

struct NamedFile {
    std::filesystem::path path;
    std::string name; ///< without the folder of the source
};

/// Size and modification time of every file, in the order given. Error: NotFound naming what is missing, Io.
core::Result<std::vector<store::SourceFile>> fingerprint(const std::vector<NamedFile>& files);

} // namespace wakesurf::importer
