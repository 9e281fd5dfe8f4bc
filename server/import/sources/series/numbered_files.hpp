// Files of one folder whose names differ by a number: the commonest way to write a series.
#pragma once

#include "core/base/result.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace wakesurf::server {

struct NumberedFiles {
    std::string name; ///< what the files share before the number, tidied
    std::vector<std::filesystem::path>
        files;                     ///< in order of their numbers; 0.25 and 12 are numbers
    std::vector<double> numbers{}; ///< of each; empty for a file alone
};

/// Whether the file name holds a `*` or a printf integer such as %04d.
bool is_pattern(const std::filesystem::path& path);

/// The files of the series that `path` (a pattern, or any file of the series: prefix + number + extension) names; a
/// file without a number, or the only one with its prefix, alone. Where a pattern has a `*`, the files have a
/// number. Error: NotFound (nothing matches), Io, InvalidArgument (two patterns in one name), Corrupt (two files
/// with one number, as flow_1 and flow_01).
core::Result<NumberedFiles> numbered_files(const std::filesystem::path& path);

} // namespace wakesurf::server
