// The tables of the state's file.
#pragma once

#include "server/sessions/journal/database.hpp"
#include "server/sessions/journal/pending_writes.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace wakesurf::server {

/// Returns the first 64 bits of SHA-256 over a row's columns with their lengths. Pure.
std::uint64_t row_digest(const StoredKey& key, std::string_view json);

/// Sums up a set of rows in any order, so that a row that was altered or is gone is noticed: how many, and
/// all their digests in one.
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

/// Holds the file's description of itself.
struct StateHead {
    std::int64_t id = 0;      ///< drawn when it was made; identifies the file
    std::int64_t commits = 0; ///< transactions since then
    std::string writer;       ///< version of the program that wrote it last

    bool operator==(const StateHead&) const = default;
};

/// Holds a record that was set aside, unchanged.
struct AsideRow {
    std::string session;
    KeptAside label;
    std::string json;
};

/// The layout, stored in the file's user_version.
inline constexpr int state_layout = 2;

/// Returns the layout of the file; 0: it is empty. Error: as Database::run; Unsupported if it has another
/// layout, or is another program's.
core::Result<int> layout_of(Database& database);

/// Makes missing tables of this layout.
core::Result<void> make_tables(Database& database, const StateHead& head);

// The statements below need a transaction.

core::Result<void>
put_row(Database& database, const StoredKey& key, const std::string& json, std::uint64_t digest);
core::Result<void> put_aside(Database& database, const AsideRow& row);

/// Writes the sum of one session, or that of all if its name is empty. Empty sums are not stored.
core::Result<void> put_sum(Database& database, const std::string& session, const RowSum& sum);
core::Result<void> put_head(Database& database, const StateHead& head);

} // namespace wakesurf::server
