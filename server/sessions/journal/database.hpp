// SQLite for this room: handles that close themselves, errors as values.
#pragma once

#include "core/base/result.hpp"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace wakesurf::server {

/// Holds one statement, to be bound and stepped any number of times. REQUIRES: its database outlives it.
class Statement {
  public:
    /// Binds the `at`-th parameter, from 1. REQUIRES: the text stays until the next reset().
    void bind(int at, std::string_view text);
    void bind(int at, std::int64_t number);

    /// Returns true with a row. Error: as Database::run.
    core::Result<bool> step();

    /// Returns the `at`-th column of the row, from 0.
    std::string text(int at) const;
    std::int64_t number(int at) const;

    /// Resets it for the next values.
    void reset();

  private:
    friend class Database;

    struct Finalize {
        void operator()(sqlite3_stmt* statement) const;
    };

    explicit Statement(sqlite3_stmt* statement) : statement_(statement) {}

    std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

/// Holds one connection; one thread at a time.
class Database {
  public:
    /// The advice for a damaged file.
    static const char* const way_out;

    /// Opens the file, and makes it if it is missing. `vfs`: SQLite's name of the file system to use; null:
    /// the usual one. Error: Io; Corrupt if the file is no database.
    static core::Result<Database> open(const std::string& file, const char* vfs);

    /// Sets whether closing moves the log into the file and removes it, the default. Without it, closing
    /// leaves a damaged log for inspection.
    void fold_log_on_close(bool fold);

    /// Copies all of it, the log included, to a new file. Error: as run().
    core::Result<void> copy_to(const std::string& file, const char* vfs);

    /// Runs statements. Error: Io (full, read-only, failing disk; locked), Corrupt.
    core::Result<void> run(const char* statements);
    core::Result<Statement> prepare(const char* statement);

    /// Returns the first column of the first row. Error: as run(); Corrupt without a row.
    core::Result<std::int64_t> number(const char* query);
    core::Result<std::string> text(const char* query);

  private:
    struct Close {
        void operator()(sqlite3* database) const;
    };

    core::Result<Statement> first_row(const char* query);

    std::unique_ptr<sqlite3, Close> database_;
};

} // namespace wakesurf::server
