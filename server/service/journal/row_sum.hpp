// Checksums of the rows of the state's file, which reveal altered and missing rows.
#pragma once

#include "server/service/journal/pending_writes.hpp"

#include <cstdint>
#include <string_view>

namespace wakesurf::server {

/// Returns the first 64 bits of SHA-256 over a row's columns with their lengths.
std::uint64_t row_digest(const StoredKey& key, std::string_view json);

/// Sums up a set of rows in any order: their number, and all their digests in one.
struct RowSum {
    std::int64_t records = 0;
    std::uint64_t digest = 0;

    void add(std::uint64_t row) {
        ++records;
        digest ^= row;
    }

    void take(std::uint64_t row) {
        --records;
        digest ^= row;
    }

    bool operator==(const RowSum&) const = default;
};

} // namespace wakesurf::server
