// What sessions need of the server.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/memory_account.hpp"
#include "core/base/result.hpp"
#include "server/service/base/unix_time.hpp"

#include <chrono>

namespace wakesurf::server {

class ComputePool;
class Datasets;
class Entropy;
class HistoryBudget;
class Journal;
class Loop;
class Metrics;

/// All outlive the sessions.
struct SessionServices {
    Loop& loop;
    ComputePool& pool;
    const Datasets& datasets;
    Entropy& entropy;
    Metrics* metrics = nullptr;         ///< no one counts without
    Journal* journal = nullptr;         ///< nothing is kept without
    const core::Clock* clock = nullptr; ///< the machine's without
    UnixTime unix_time = unix_seconds;
    const core::MemoryAccount* memory = nullptr; ///< no one counts without
    const core::Error* withheld =
        nullptr; ///< why restored surfaces are not computed; they are without
    const HistoryBudget* histories = nullptr; ///< each surface has its own without

    const core::Clock& wall() const {
        static const core::SteadyClock machine;
        return clock == nullptr ? machine : *clock;
    }

    std::chrono::steady_clock::time_point now() const { return wall().now(); }
};

} // namespace wakesurf::server
