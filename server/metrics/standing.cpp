#include "server/metrics/standing.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace wakesurf::server {

MemoryStanding memory_standing(const core::MemoryAccount& account) {
    MemoryStanding out{account.budget(), account.used(), {}, account.refused()};
    for (std::size_t i = 0; i < out.by_use.size(); ++i)
        out.by_use[i] = account.used(static_cast<core::MemoryUse>(i));
    return out;
}

ProcessMemory process_memory() {
    ProcessMemory out;
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        std::istringstream words(line);
        std::string name;
        std::uint64_t kibibytes = 0;
        if (!(words >> name >> kibibytes))
            continue;
        if (name == "VmRSS:")
            out.resident = kibibytes << 10;
        else if (name == "VmHWM:")
            out.peak = kibibytes << 10;
    }
    std::error_code error;
    const std::filesystem::directory_iterator open("/proc/self/fd", error);
    if (!error)
        out.descriptors = static_cast<std::uint64_t>(std::distance(begin(open), end(open)));
    return out;
}

} // namespace wakesurf::server
