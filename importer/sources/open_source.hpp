// Which format a path is in, and that format's reader.
#pragma once

#include "command/source_options.hpp"
#include "core/base/result.hpp"
#include "importer/base/source.hpp"

#include <filesystem>
#include <memory>

namespace wakesurf::importer {

/// The reader of the format that `path` (a file, or any of a numbered series, or a pattern of one) is in.
/// @param wish  the velocity somebody asks for decides which blocks are fluid, and which fields every time-step must have
/// Error: NotFound, Io, Unsupported (the formats there are), Corrupt.
core::Result<std::unique_ptr<Source>> open_source(const std::filesystem::path& path,
                                                  const command::SourceOptions& wish = {});

} // namespace wakesurf::importer
