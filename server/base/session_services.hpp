// The parts of the server that sessions use.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/memory_account.hpp"
#include "core/base/result.hpp"
#include "server/base/unix_time.hpp"

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>

namespace wakesurf::server {

class ComputePool;
class Datasets;
class Entropy;
class HistoryBudget;
class Journal;
class Loop;
class Metrics;

/// Refers to parts of the server, which outlive all sessions.
struct SessionServices {
    Loop& loop;
    ComputePool& pool;
    const Datasets& datasets;
    Entropy& entropy;
    Metrics* metrics = nullptr;         ///< null: not counted
    Journal* journal = nullptr;         ///< null: sessions are not stored
    const core::Clock* clock = nullptr; ///< null: the machine's
    UnixTime unix_time = unix_seconds;
    /// Null: not counted.
    const core::MemoryAccount* memory = nullptr;
    /// The reason why restored surfaces are not computed; null: they are.
    const core::Error* withheld = nullptr;
    /// Returns the bytes of the records of all copies by a link; empty: not counted.
    std::function<std::size_t(const std::string& link)> records_of_copies{};
    /// Null: each surface has its own.
    const HistoryBudget* histories = nullptr;

    const core::Clock& wall() const {
        static const core::SteadyClock machine;
        return clock == nullptr ? machine : *clock;
    }

    std::chrono::steady_clock::time_point now() const { return wall().now(); }
};

} // namespace wakesurf::server
