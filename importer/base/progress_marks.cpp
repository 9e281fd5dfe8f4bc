#include "importer/base/progress_marks.hpp"

#include <sys/mman.h>

#include <new>

namespace wakesurf::importer {

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

} // namespace wakesurf::importer
