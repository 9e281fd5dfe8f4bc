// Files made of other files: .vtm (blocks, nested), .pvtu and .pvtp (pieces); and every other file, alone.
#pragma once

#include "importer/sources/series/file_series.hpp"

namespace wakesurf::importer {

struct CompositeFile {
    std::vector<ListedFile>
        files; ///< all: the composite ones, the leaves, the pieces that leaves are made of
    std::vector<ListedFile>
        leaves; ///< those that are read, in order; `block` says where they stand
};

/// By extension: .vtm, .vtmb, .pvtu and the like.
bool names_others(const std::filesystem::path& path);

/// Reads the composite files, not the leaves, but all are there. Error: NotFound (naming who names the missing file),
/// Io, Corrupt, Unsupported (nested too deeply). REQUIRES: no VtkMessages lives.
core::Result<CompositeFile> expand(const ListedFile& file);

} // namespace wakesurf::importer
