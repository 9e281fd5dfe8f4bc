#include "tests/bench/load/memory_group.hpp"

#include <unistd.h>

#include <fstream>
#include <string_view>
#include <system_error>

namespace wakesurf::bench {

namespace fs = std::filesystem;

namespace {

bool write(const fs::path& file, const std::string& text) {
    std::ofstream out(file);
    out << text << std::flush;
    return out.good();
}

} // namespace

MemoryGroup::MemoryGroup(std::size_t bytes) {
    const std::string name = "wakesurf-bench-" + std::to_string(::getpid());

    struct Place {
        const char* top;
        const char* limit;
        bool second;
    };

    constexpr Place places[]{{"/sys/fs/cgroup/memory", "memory.limit_in_bytes", false},
                             {"/sys/fs/cgroup", "memory.max", true}};
    for (const Place& each : places) {
        std::error_code error;
        const fs::path folder = fs::path(each.top) / name;
        if (each.second)
            write(fs::path(each.top) / "cgroup.subtree_control", "+memory");
        if (fs::create_directory(folder, error) &&
            write(folder / each.limit, std::to_string(bytes))) {
            folder_ = folder;
            second_ = each.second;
            write(folder / "memory.swap.max",
                  "0"); // version 1 of a machine without swap needs nothing
            return;
        }
        fs::remove(folder, error);
        why_ += (why_.empty() ? "" : ", ") + std::string(each.top) + " cannot be used";
    }
}

MemoryGroup::~MemoryGroup() {
    std::error_code
        error; // of a process that is still there: the group stays, and goes with the machine
    if (there())
        fs::remove(folder_, error);
}

std::vector<std::string> MemoryGroup::launcher() const {
    if (!there())
        return {};
    // The shell enters before it becomes the program: nothing is taken outside.
    return {"/bin/sh", "-c", "echo $$ > \"$0\" && exec \"$@\"",
            (folder_ / "cgroup.procs").string()};
}

std::uint64_t MemoryGroup::killed() const {
    if (!there())
        return 0;
    std::ifstream in(folder_ / (second_ ? "memory.events" : "memory.oom_control"));
    std::uint64_t number = 0;
    for (std::string name; in >> name >> number;)
        if (name == "oom_kill")
            return number;
    return 0;
}

} // namespace wakesurf::bench
