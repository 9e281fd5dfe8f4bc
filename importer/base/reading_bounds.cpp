#include "importer/base/reading_bounds.hpp"

#include <sys/mman.h>

#include <new>

namespace wakesurf::importer {

namespace {

std::uint64_t memory_bound = 0; ///< 0: none

} // namespace

ProgressMarks& progress_marks() {
    static ProgressMarks* const shared = [] {
        void* const memory = ::mmap(nullptr, sizeof(ProgressMarks), PROT_READ | PROT_WRITE,
                                    MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        if (memory == MAP_FAILED)
            throw std::bad_alloc();
        return new (memory) ProgressMarks; // until the process ends
    }();
    return *shared;
}

void made_progress() {
    ++progress_marks().progress;
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

} // namespace wakesurf::importer
