// The state of the server at the moment of a request: what is open, held and used. Gathered on request.
#pragma once

#include "core/base/memory_account.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

struct CacheStanding {
    std::string dataset;
    std::uint64_t hits = 0;  ///< requested time-steps that were in memory
    std::uint64_t loads = 0; ///< those that were not
    std::size_t bytes = 0;
    std::size_t budget = 0;
};

/// Describes the bricks of a dataset with an MPI job.
struct BricksStanding {
    std::string dataset;
    std::uint64_t by_ranks = 0;
    std::uint64_t by_files = 0;
    std::uint64_t ranks = 0; ///< of the job; 0: not connected
};

/// Counts the datasets in a state.
struct DatasetCount {
    std::string_view state;
    std::size_t count = 0;

    bool operator==(const DatasetCount&) const = default;
};

/// Returns the text of /healthz: "ok", and how many of how many datasets failed or are incomplete. No names:
/// it is public.
std::string health_text(std::span<const DatasetCount> datasets);

/// Describes the account of memory, in bytes.
struct MemoryStanding {
    std::size_t budget = 0;
    std::size_t used = 0;
    std::array<std::size_t, core::memory_uses> by_use{};
    std::uint64_t refused = 0; ///< requests that did not fit
};

MemoryStanding memory_standing(const core::MemoryAccount& account);

struct Standing {
    double uptime = 0.0; ///< seconds
    std::size_t connections = 0;
    std::size_t clients = 0; ///< WebSockets
    std::size_t sessions = 0;
    std::size_t surfaces = 0;
    std::size_t participants = 0;
    std::vector<DatasetCount> datasets; ///< of each state
    std::vector<CacheStanding> caches;
    std::vector<BricksStanding> bricks;
    MemoryStanding memory;
};

struct ProcessMemory {
    std::uint64_t resident = 0; ///< bytes
    std::uint64_t peak = 0;     ///< bytes, of `resident`
    std::uint64_t descriptors = 0;
};

/// Describes this process, from /proc; zeros if there is none. Cost: tens of microseconds.
ProcessMemory process_memory();

} // namespace wakesurf::server
