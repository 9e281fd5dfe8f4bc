// A disk in memory for SQLite that does what disks do at their worst: refuses the n-th operation, and at a power cut
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

/// Usable from any thread; outlives the databases on it.
class FaultyDisk {
  public:
    FaultyDisk();
    ~FaultyDisk();
    FaultyDisk(const FaultyDisk&) = delete;
    FaultyDisk& operator=(const FaultyDisk&) = delete;

    /// For sqlite3_open_v2.
    const char* name() const { return name_.c_str(); }

    /// The `at`-th write, truncation, sync or deletion from now on (1: the next) returns SQLite's error `code`, a write having done half
    /// of its work; what a refused sync should have brought to the disk never gets there. `for_good`: and all after it.
    void refuse(int at, int code, bool for_good);

    /// Whether the refusal came; ends it.
    bool heal();

    /// Of the sectors that were not synced, random ones are on the disk, the others as they were before.
    void cut_power(std::mt19937_64& random);

    /// What cut_power would leave, on `other`. REQUIRES: nothing is open there.
    void cut_power_onto(FaultyDisk& other, std::mt19937_64& random) const;

  private:
    struct File {
        std::vector<char> seen;
        std::vector<char> kept;
        std::set<std::size_t> unsynced; ///< sectors
    };

    struct Handle;
    struct Calls;

    /// With the lock held: SQLite's code for the operation that begins now.
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
