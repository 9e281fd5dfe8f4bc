// Detects a server that crashes repeatedly while it starts, so that the next start can leave out the likely
// cause.
#pragma once

#include <filesystem>

namespace wakesurf::server {

/// Counts failed starts in a file in the folder of `--state`; in a read-only folder they are not counted.
/// Loop thread only.
class CrashLoopGuard {
  public:
    /// The number of crashes after which the next start is a careful one.
    static constexpr unsigned most = 3;

    /// Begins a start. @param folder  locked by this process
    explicit CrashLoopGuard(const std::filesystem::path& folder);

    /// Returns the number of crashed starts in a row before this one.
    unsigned died() const { return died_; }

    bool careful() const { return died_ >= most; }

    /// Resets the count: the server has served for a while, or ends normally. Waits for the disk.
    void good();

  private:
    std::filesystem::path file_;
    unsigned died_ = 0;
    bool good_ = false;
};

} // namespace wakesurf::server
