// A control group of its own for a process that is to be kept from taking more memory than it may.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace wakesurf::bench {

/// Of version 1 or 2, wherever this process may make one; removed at the end.
class MemoryGroup {
  public:
    explicit MemoryGroup(std::size_t bytes);
    ~MemoryGroup();
    MemoryGroup(const MemoryGroup&) = delete;
    MemoryGroup& operator=(const MemoryGroup&) = delete;

    /// False: this machine lets no one make one; why() says what was tried.
    bool there() const { return !folder_.empty(); }

    const std::string& why() const { return why_; }

    /// What starts `program` inside; the program itself where there is no group.
    std::vector<std::string> command(const std::filesystem::path& program) const;

    /// How often the kernel had to end a process of it.
    std::uint64_t killed() const;

  private:
    std::filesystem::path folder_;
    std::string why_;
    bool second_ = false; ///< version
};

} // namespace wakesurf::bench
