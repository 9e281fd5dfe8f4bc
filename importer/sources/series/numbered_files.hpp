// Files of one folder whose names differ by a number: the commonest way to write a series.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace wakesurf::importer {

struct NumberedFiles {
    std::string name; ///< the common part of the names before the number, tidied
    std::vector<std::filesystem::path> files; ///< in order of their numbers: 5 before 10
    std::vector<double> numbers{};            ///< of each; empty for a file alone
};

/// Says whether the file name holds a `*` or a printf integer such as %04d.
bool is_pattern(const std::filesystem::path& path);

/// Returns the files of the series that `path` (a pattern, or any file of the series) names: those whose
/// names differ by the last number, so that out1.0001 and out2.0001 are two series, and so are flow_1 and
/// flow_01. A file without a number, or the only one of its series, is alone. If a pattern has a `*`, the
/// files have a number. Error: NotFound (nothing matches), Io, InvalidArgument (two patterns in one name),
/// Corrupt (two files with one number).
/// @param alone  the file itself, whatever its number
core::Result<NumberedFiles> numbered_files(const std::filesystem::path& path, bool alone = false);

} // namespace wakesurf::importer
