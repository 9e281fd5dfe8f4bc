// The tables of the state's file, and how those of older versions become those of this one.
#pragma once

#include "server/service/journal/database.hpp"
#include "server/service/journal/pending_writes.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::server {

/// Returns the first 64 bits of SHA-256 over a row's columns with their lengths. Pure.
std::uint64_t row_digest(const StoredKey& key, std::string_view json);

/// Sums up a set of rows in any order, so that a row that was altered or is gone is noticed: how many, and all their
/// digests in one.
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

/// Holds what the file says of itself.
struct StateHead {
    std::int64_t id = 0;      ///< drawn when it was made, so that it is known from others
    std::int64_t commits = 0; ///< transactions since then
    std::string writer;       ///< version of the program that wrote it last

    bool operator==(const StateHead&) const = default;
};

/// Holds a record out of use, as it was.
struct AsideRow {
    std::string session;
    KeptAside label;
    std::string json;
};

/// Is kept in the file's user_version.
inline constexpr int state_layout = 2;

/// Returns the layout of the file; 0: nothing is in it. Error: as Database::run; Unsupported where it is a
/// newer program's, or another's.
core::Result<int> layout_of(Database& database);

/// Makes the tables of this layout where there are none.
core::Result<void> make_tables(Database& database, const StateHead& head);

/// Makes a file of layout 1 one of this layout, as a whole or not at all. `rows`: what is in it.
core::Result<void> migrate(Database& database,
                           const StateHead& head,
                           const std::map<std::string, std::vector<JournalEntry>>& rows);

// The statements of what follows need a transaction.

core::Result<void>
put_row(Database& database, const StoredKey& key, const std::string& json, std::uint64_t digest);
core::Result<void> put_aside(Database& database, const AsideRow& row);

/// Writes the sum of one session, or of all together where its name is empty. A sum of nothing is not kept.
core::Result<void> put_sum(Database& database, const std::string& session, const RowSum& sum);
core::Result<void> put_head(Database& database, const StateHead& head);

} // namespace wakesurf::server
