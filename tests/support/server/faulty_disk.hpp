// A disk in memory for SQLite that fails like real disks: it refuses the n-th operation, and at a power cut
// loses what was not synced.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <random>
#include <set>
#include <string>
#include <vector>

struct sqlite3_vfs;

namespace wakesurf::tests {

/// Simulates a disk. Thread-safe; outlives the databases on it.
class FaultyDisk {
  public:
    FaultyDisk();
    ~FaultyDisk();
    FaultyDisk(const FaultyDisk&) = delete;
    FaultyDisk& operator=(const FaultyDisk&) = delete;

    /// Returns the name for sqlite3_open_v2.
    const char* name() const { return name_.c_str(); }

    /// Makes the `at`-th write, truncation, sync or deletion from now on (1: the next) return SQLite's error
    /// `code`. A write does half of its work first; data of a refused sync never reach the disk. `for_good`:
    /// and all after it.
    void refuse(int at, int code, bool for_good);

    /// Ends the refusal; says whether it occurred.
    bool heal();

    /// Writes random ones of the sectors that were not synced; the others stay as they were before.
    void cut_power(std::mt19937_64& random);

    /// Writes the result of cut_power to `other`. REQUIRES: nothing is open there.
    void cut_power_onto(FaultyDisk& other, std::mt19937_64& random) const;

  private:
    struct File {
        std::vector<char> seen;
        std::vector<char> kept;
        std::set<std::size_t> unsynced; ///< sectors
    };

    struct Handle;
    struct Calls;

    /// Returns SQLite's code for the operation that begins now. REQUIRES: the lock.
    int verdict();
    static void survive(File& file, std::mt19937_64& random);

    mutable std::mutex mutex_;
    std::string name_;
    std::unique_ptr<sqlite3_vfs> vfs_;
    std::map<std::string, std::shared_ptr<File>> files_;
    int until_refusal_ = -1; ///< operations; negative: never
    int code_ = 0;
    bool for_good_ = false;
    bool refused_ = false;
};

} // namespace wakesurf::tests
