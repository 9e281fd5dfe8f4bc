// Files made of other files: .vtm (blocks, nested), .pvtu and .pvtp (pieces); and every other file, alone.
#pragma once

#include "importer/sources/series/file_series.hpp"

namespace wakesurf::importer {

struct CompositeFile {
    /// All files: the composite ones, the leaves, the pieces that leaves are made of.
    std::vector<ListedFile> files;
    /// The files that are read, in order; `block` is their position among the blocks.
    std::vector<ListedFile> leaves;
    /// Names a .vtm that ends before its elements do: what it lists may not be all.
    std::string cut{};
};

/// Decides by the extension: .vtm, .vtmb, .pvtu and the like.
bool names_others(const std::filesystem::path& path);

/// Reads the composite files, not the leaves, but checks that all exist. Error: NotFound (naming the file
/// that names the missing one), Io, Corrupt, Unsupported (nested too deeply). REQUIRES: no VtkMessages lives.
core::Result<CompositeFile> expand(const ListedFile& file);

} // namespace wakesurf::importer
