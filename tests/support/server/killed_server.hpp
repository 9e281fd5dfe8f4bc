// The real server, killed (SIGKILL) at random points under edits and started again, over and over.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace wakesurf::tests {

struct KillReport {
    int kills = 0;
    std::size_t answered = 0; ///< edits
    /// Answered edits that were lost, and edits that were never made.
    std::vector<std::string> wrong;
    /// The times from the start of the program to the answer that has every record (ms).
    std::vector<double> ready_ms;
};

/// Runs it in `state`, a folder of its own. Throws if the server does not start or refuses a valid call.
KillReport kill_under_edits(const std::filesystem::path& state, std::uint64_t seed, int kills);

} // namespace wakesurf::tests
