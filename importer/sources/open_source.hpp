// Finds the format that a path is in, and that format's reader.
#pragma once

#include "core/base/result.hpp"
#include "importer/base/source.hpp"
#include "store/command/source_options.hpp"

#include <filesystem>
#include <memory>

namespace wakesurf::importer {

/// Opens `path` (a file, or any of a numbered series, or a pattern of one) with the reader of its format.
/// Error: NotFound, Io, Unsupported (listing the formats), Corrupt.
/// @param wish  the velocity asked for decides which blocks are fluid, and which fields every time-step must
/// have
core::Result<std::unique_ptr<Source>> open_source(const std::filesystem::path& path,
                                                  const command::SourceOptions& wish = {});

} // namespace wakesurf::importer
