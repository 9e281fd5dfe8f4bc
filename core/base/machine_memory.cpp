#include "core/base/machine_memory.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace wakesurf::core {

namespace {

namespace fs = std::filesystem;

constexpr auto unlimited = std::numeric_limits<std::uint64_t>::max();

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> out;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, at);)
        out.push_back(part);
    return out;
}

bool among(const std::string& wanted, const std::string& list) {
    const auto all = split(list, ',');
    return std::find(all.begin(), all.end(), wanted) != all.end();
}

/// The mount point of a hierarchy of control groups with the memory controller. (proc(5),
/// /proc/self/mountinfo)
struct Hierarchy {
    int version;
    fs::path top; ///< the group that is mounted, as /proc/self/cgroup names groups
    fs::path mounted;
};

std::vector<Hierarchy> hierarchies(const fs::path& root) {
    std::vector<Hierarchy> out;
    std::ifstream file(root / "proc/self/mountinfo");
    for (std::string line; std::getline(file, line);) {
        const auto dash = line.find(" - ");
        const auto before = split(line.substr(0, dash), ' ');
        const auto after = dash == std::string::npos ? std::vector<std::string>{}
                                                     : split(line.substr(dash + 3), ' ');
        if (before.size() < 5 || after.size() < 3)
            continue;
        const bool first = after[0] == "cgroup" && among("memory", after[2]);
        if (first || after[0] == "cgroup2")
            out.push_back({first ? 1 : 2, before[3], before[4]});
    }
    return out;
}

/// Returns the group of this process in a hierarchy. (cgroups(7): hierarchy:controllers:path)
std::optional<fs::path> own_group(const fs::path& root, int version) {
    std::ifstream file(root / "proc/self/cgroup");
    for (std::string line; std::getline(file, line);) {
        const auto first = line.find(':');
        const auto second = line.find(':', first + 1);
        if (first == std::string::npos || second == std::string::npos)
            continue;
        const std::string controllers = line.substr(first + 1, second - first - 1);
        if (version == 2 ? controllers.empty() : among("memory", controllers))
            return fs::path(line.substr(second + 1));
    }
    return std::nullopt;
}

/// Returns the limit in one file, which holds a number of bytes or "max".
std::uint64_t limit_in(const fs::path& file) {
    std::ifstream in(file);
    std::uint64_t bytes = 0;
    return in >> bytes ? bytes : unlimited;
}

/// Returns the limit of a group itself, without the groups that contain it.
std::uint64_t limit_of(const fs::path& group, int version) {
    if (version == 1)
        return limit_in(group / "memory.limit_in_bytes");
    return std::min(limit_in(group / "memory.max"), limit_in(group / "memory.high"));
}

std::uint64_t least_limit(const fs::path& root, const Hierarchy& hierarchy) {
    const auto own = own_group(root, hierarchy.version);
    if (!own)
        return unlimited;
    const fs::path mounted = root / hierarchy.mounted.relative_path();
    // Inside a container the mount may show no more than the container's group, which is then its top.
    fs::path below = own->lexically_relative(hierarchy.top);
    if (below.empty() || *below.begin() == "..")
        below = ".";
    std::uint64_t least = limit_of(mounted, hierarchy.version);
    fs::path group = mounted;
    for (const fs::path& name : below) {
        group /= name;
        least = std::min(least, limit_of(group, hierarchy.version));
    }
    return least;
}

} // namespace

std::uint64_t machine_memory() {
    const auto pages = ::sysconf(_SC_PHYS_PAGES);
    const auto page = ::sysconf(_SC_PAGESIZE);
    return pages > 0 && page > 0
               ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page)
               : 0;
}

std::uint64_t granted_memory(const fs::path& root) {
    std::uint64_t least = machine_memory() > 0 ? machine_memory() : unlimited;
    for (const Hierarchy& each : hierarchies(root))
        least = std::min(least, least_limit(root, each));
    return least == unlimited ? 0 : least;
}

std::uint64_t resident_memory() {
    // This opens no stream, because it is called while memory is being taken.
    const int file = ::open("/proc/self/statm", O_RDONLY | O_CLOEXEC);
    if (file < 0)
        return 0;
    std::array<char, 128> text{};
    const auto length = ::read(file, text.data(), text.size());
    ::close(file);
    const std::string_view words(text.data(), length > 0 ? static_cast<std::size_t>(length) : 0);
    const auto second = words.find(' ') + 1; // npos + 1 == 0: the first, which is no less
    std::uint64_t pages = 0;
    std::from_chars(words.data() + second, words.data() + words.size(), pages);
    const auto page = ::sysconf(_SC_PAGESIZE);
    return page > 0 ? pages * static_cast<std::uint64_t>(page) : 0;
}

// Not getrusage, which tells of the program before exec() as well: of whoever started this one.
std::uint64_t peak_resident_memory() {
    std::ifstream status("/proc/self/status");
    std::string word;
    std::uint64_t kibi = 0;
    while (status >> word)
        if (word == "VmHWM:" && status >> kibi)
            return kibi * 1024;
    return 0;
}

} // namespace wakesurf::core
