#include "importer/worker_count.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

namespace wakesurf::importer {

namespace {

// MemAvailable of /proc/meminfo in bytes; 0 where it is not known.
std::size_t free_memory() {
    std::ifstream in("/proc/meminfo");
    std::string name;
    std::string unit;
    for (std::size_t kilobytes = 0; in >> name >> kilobytes; std::getline(in, unit))
        if (name == "MemAvailable:")
            return kilobytes * 1024;
    return 0;
}

} // namespace

std::size_t worker_count(const ImportPlan& plan, std::size_t nodes) {
    const std::size_t wanted =
        plan.jobs > 0 ? plan.jobs : std::max(1u, std::thread::hardware_concurrency());
    // A reader holds a file about twice while it decodes; averaging holds sums in double.
    constexpr std::size_t a_node = 64;
    constexpr std::size_t copies = 3;
    std::size_t a_step = a_node * nodes;
    for (const auto& file : plan.made_from.steps.front())
        a_step += copies * static_cast<std::size_t>(file.size);
    std::size_t memory = free_memory() / 2;
    // What is allowed is shared with the first time-step, which the process that starts the others holds.
    const std::size_t allowed = plan.memory - std::min<std::size_t>(plan.memory, a_step);
    if (plan.memory > 0)
        memory = memory == 0 ? allowed : std::min(memory, allowed);
    return memory == 0 && plan.memory == 0
               ? wanted
               : std::clamp<std::size_t>(memory / std::max<std::size_t>(a_step, 1), 1, wanted);
}

bool reads_open_files() {
    DIR* list = ::opendir("/proc/self/fd");
    if (list == nullptr)
        return true;
    bool found = false;
    while (const dirent* entry = ::readdir(list)) {
        char* end = nullptr;
        const long file = std::strtol(entry->d_name, &end, 10);

        struct stat state {};

        if (end == entry->d_name || file <= STDERR_FILENO ||
            ::fstat(static_cast<int>(file), &state) != 0 || !S_ISREG(state.st_mode))
            continue;
        found = found || (::fcntl(static_cast<int>(file), F_GETFL) & O_ACCMODE) == O_RDONLY;
    }
    ::closedir(list);
    return found;
}

} // namespace wakesurf::importer
