// A series whose import takes seconds: many names of one file that takes long to read, as text does.
#pragma once

#include "tests/support/temporary_folder.hpp"
#include "tests/support/vti_text.hpp"

#include <cstddef>
#include <filesystem>
#include <string>

namespace wakesurf::tests {

/// Writes u_00.vti, u_01.vti, ... with velocity (0.5, 0.5, 0.5); returns the first.
inline std::filesystem::path write_slow_series(const std::filesystem::path& folder,
                                               std::size_t steps = 40) {
    const auto name = [&](std::size_t step) {
        return folder / ("u_" + std::string(step < 10 ? "0" : "") + std::to_string(step) + ".vti");
    };
    VtiText text;
    text.nodes = {48, 48, 48};
    text.points = vti_array("U", 3, text.point_count(), [](std::size_t) { return 0.5; });
    write_file(name(0), text.text());
    for (std::size_t step = 1; step < steps; ++step)
        std::filesystem::create_hard_link(name(0), name(step));
    return name(0);
}

/// Counts the files under a folder that are still being written.
inline std::size_t unfinished_files(const std::filesystem::path& folder) {
    std::size_t count = 0;
    std::error_code ignored;
    for (const auto& each : std::filesystem::recursive_directory_iterator(folder, ignored))
        count += each.path().extension() == ".part" ? 1 : 0;
    return count;
}

} // namespace wakesurf::tests
