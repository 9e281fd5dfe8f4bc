// Files for readers that take paths: one folder a process, written again for each input.
#pragma once

#include "tests/fuzz/target.hpp"
#include "tests/support/temporary_folder.hpp"

#include <filesystem>
#include <string_view>

namespace wakesurf::fuzz {

/// Writes `bytes` to a file of this name, replacing an earlier one.
inline std::filesystem::path scratch_file(std::string_view name, std::string_view bytes) {
    static const tests::TemporaryFolder folder;
    const auto path = folder / name;
    tests::write_file(path, bytes);
    return path;
}

} // namespace wakesurf::fuzz
