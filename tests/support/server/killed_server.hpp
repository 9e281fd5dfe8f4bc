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
    std::size_t answered = 0;       ///< edits
    std::vector<std::string> wrong; ///< answered edits that were lost, and what no one made
    std::vector<double>
        ready_ms; ///< from the start of the program to the answer that has every record
};

/// `state`: a folder of its own. Throws where the server does not start or refuses what it must not.
KillReport kill_under_edits(const std::filesystem::path& state, std::uint64_t seed, int kills);

/// Milliseconds as in KillReport::ready_ms of `restarts` after kills, with `sessions` of `surfaces` rakes and surfaces each.
std::vector<double>
restart_with_sessions(const std::filesystem::path& state, int sessions, int surfaces, int restarts);

} // namespace wakesurf::tests
