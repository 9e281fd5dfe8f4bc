// A control group that limits the memory of a process.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace wakesurf::bench {

/// Makes a group of version 1 or 2, wherever this process may; removed at the end.
class MemoryGroup {
  public:
    explicit MemoryGroup(std::size_t bytes);
    ~MemoryGroup();
    MemoryGroup(const MemoryGroup&) = delete;
    MemoryGroup& operator=(const MemoryGroup&) = delete;

    /// Returns false if this machine does not allow it; why() says what was tried.
    bool there() const { return !folder_.empty(); }

    const std::string& why() const { return why_; }

    /// Returns the words before those that start a program, so that it starts inside; none without a group.
    std::vector<std::string> launcher() const;

    /// Returns how often the kernel had to kill a process of it.
    std::uint64_t killed() const;

  private:
    std::filesystem::path folder_;
    std::string why_;
    bool second_ = false; ///< version
};

} // namespace wakesurf::bench
