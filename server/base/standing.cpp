#include "server/base/standing.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

namespace wakesurf::server {

std::string health_text(std::span<const DatasetCount> datasets) {
    std::size_t total = 0;
    std::string wrong;
    for (const DatasetCount& each : datasets) {
        total += each.count;
        if (each.count == 0)
            continue;
        const std::string is = each.count == 1 ? " is " : " are ";
        const std::string has = each.count == 1 ? " has " : " have ";
        const std::string said = each.state == "failed"       ? has + "failed"
                                 : each.state == "incomplete" ? is + "incomplete"
                                                              : std::string();
        if (!said.empty())
            wrong += (wrong.empty() ? "" : ", ") + std::to_string(each.count) + said;
    }
    return wrong.empty() ? "ok" : "ok, but of " + std::to_string(total) + " datasets " + wrong;
}

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
