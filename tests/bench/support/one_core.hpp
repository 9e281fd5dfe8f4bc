// Runs work on one core, so that figures compare whatever the machine.
#pragma once

#include <tbb/task_arena.h>

namespace wakesurf::bench {

template <class Work>
decltype(auto) on_one_core(const Work& work) {
    tbb::task_arena arena(1);
    return arena.execute(work);
}

} // namespace wakesurf::bench
