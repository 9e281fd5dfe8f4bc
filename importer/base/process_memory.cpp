#include "importer/base/process_memory.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>
#include <string_view>

namespace wakesurf::importer {

namespace {

std::uint64_t memory_bound = 0; ///< 0: none

namespace fs = std::filesystem;

fs::path shown(pid_t process, std::string_view file) {
    return fs::path("/proc") / std::to_string(process) / file;
}

// Returns the sum of lines "Name:   123 kB" in bytes; 0 for a missing file: the process has ended.
std::uint64_t kilobytes_in(const fs::path& file, std::initializer_list<std::string_view> names) {
    std::ifstream in(file);
    std::uint64_t sum = 0;
    for (std::string line; std::getline(in, line);)
        for (const auto name : names)
            if (line.starts_with(name))
                sum += std::strtoull(line.c_str() + name.size(), nullptr, 10) * 1024;
    return sum;
}

void add_below(pid_t process, std::vector<pid_t>& found) {
    std::error_code gone;
    for (fs::directory_iterator thread(shown(process, "task"), gone), end; !gone && thread != end;
         thread.increment(gone)) {
        std::ifstream in(thread->path() / "children");
        for (pid_t child = 0; in >> child;) {
            found.push_back(child);
            add_below(child, found);
        }
    }
}

} // namespace

std::vector<pid_t> processes_below(pid_t process) {
    std::vector<pid_t> found;
    add_below(process, found);
    return found;
}

std::uint64_t quick_memory(const std::vector<pid_t>& processes) {
    std::uint64_t sum = 0;
    for (const pid_t process : processes)
        sum += kilobytes_in(shown(process, "status"), {"RssAnon:", "RssShmem:"});
    return sum;
}

std::uint64_t exact_memory(const std::vector<pid_t>& processes) {
    std::uint64_t sum = 0;
    for (const pid_t process : processes)
        sum += kilobytes_in(shown(process, "smaps_rollup"), {"Pss_Anon:", "Pss_Shmem:"});
    return sum > 0 ? sum : quick_memory(processes); // before Linux 5.4
}

std::uint64_t bytes_read_by(pid_t process) {
    std::ifstream in(shown(process, "io"));
    std::string name;
    std::uint64_t bytes = 0;
    return in >> name >> bytes && name == "rchar:" ? bytes : 0;
}

void set_memory_bound(std::uint64_t bytes) {
    memory_bound = bytes;
}

core::Result<void> check_claim(const std::string& name, std::uint64_t count, std::uint64_t bytes) {
    if (memory_bound == 0 || bytes == 0 || count <= memory_bound / bytes)
        return {};
    return core::fail(core::Error::Code::OverLimit,
                      name + " says that it holds more than fits into memory");
}

core::Result<void> check_processes_show() {
    const pid_t own = ::getpid();
    std::error_code error;
    const auto children = shown(own, "task") / std::to_string(own) / "children";
    if (fs::exists(children, error) && quick_memory({own}) > 0)
        return {};
    return core::fail(core::Error::Code::Unsupported,
                      "this system does not show the memory of processes",
                      "mount /proc, and use a kernel with /proc/PID/task/TID/children");
}

} // namespace wakesurf::importer
