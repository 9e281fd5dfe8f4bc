// The share of imports in the account of memory: they are other processes of the same machine.
#pragma once

#include "server/service/catalogue/open_dataset.hpp"

#include <chrono>
#include <cstddef>
#include <stop_token>

namespace wakesurf::server {

// The least memory for the importer: with less, none could begin.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr std::size_t smallest_import = std::size_t{1} << 30;
#else
inline constexpr std::size_t smallest_import = std::size_t{64} << 20;
#endif

inline constexpr std::size_t import_part =
    4; // the divisor: imports take one part in four of all memory

/// Takes the memory of a running import from the account. Waits until others have released it.
/// @param nth  part of the memory for imports
inline core::Result<core::MemoryAccount::Share>
import_memory(const OpenOptions& options, std::size_t nth, const std::stop_token& stop) {
    constexpr std::chrono::seconds patience{30};
    if (!options.cache.account)
        return core::MemoryAccount::Share();
    auto share = options.cache.account->open(core::MemoryUse::Importers);
    const std::size_t bytes = options.cache.account->budget() / import_part / nth;
    if (share.grow_to(bytes, stop, patience) || stop.stop_requested())
        return share;
    return tl::unexpected(options.cache.account->refusal("importing", bytes));
}

} // namespace wakesurf::server
