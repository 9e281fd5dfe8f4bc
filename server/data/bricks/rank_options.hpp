// The start of a job that holds bricks, and the time limits for it.
#pragma once

#include "core/base/clock.hpp"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

namespace wakesurf::server {

struct RankOptions {
    using Duration = std::chrono::milliseconds;

    /// The words before the program: "mpirun", "-n", "4".
    std::vector<std::string> words;
    std::filesystem::path program; ///< wakesurf-bricks
    std::filesystem::path store;
    std::uint64_t memory = 0; ///< of each rank; 0: what the program needs
    /// The pause before a job is started again; it doubles each time.
    Duration first_rest{1000};
    Duration longest_rest{60'000};
    Duration coming{120'000};           ///< for the job to identify itself
    Duration patience{1000};            ///< for a brick; then it is read from files
    Duration hung{30'000};              ///< for a brick; then the job is ended
    std::stop_token closing{};          ///< ends the job: those of all datasets at a time
    const core::Clock* clock = nullptr; ///< outlives this; null: the machine's

    const core::Clock& wall() const {
        static const core::SteadyClock machine;
        return clock == nullptr ? machine : *clock;
    }
};

} // namespace wakesurf::server
