#include "core/base/machine_memory.hpp"

#include <unistd.h>

namespace wakesurf::core {

std::uint64_t machine_memory() {
    const auto pages = ::sysconf(_SC_PHYS_PAGES);
    const auto page = ::sysconf(_SC_PAGESIZE);
    return pages > 0 && page > 0
               ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page)
               : 0;
}

} // namespace wakesurf::core
