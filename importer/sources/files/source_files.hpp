// The files of a source, by their names for people, and their state, which decides whether an import of them
// is still good.
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

/// Returns size and modification time of every file, in the order given. Error: NotFound naming the missing
/// file, Io.
core::Result<std::vector<store::SourceFile>> fingerprint(const std::vector<NamedFile>& files);

} // namespace wakesurf::importer
