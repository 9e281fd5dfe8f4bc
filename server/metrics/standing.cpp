#include "server/metrics/standing.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace wakesurf::server {

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
