// Tells whether a thread sleeps, for tests that begin once another thread waits.
#pragma once

#include <sys/syscall.h>
#include <unistd.h>

#include <fstream>
#include <string>

namespace wakesurf::tests {

inline int this_thread_id() {
    return static_cast<int>(syscall(SYS_gettid));
}

/// Says whether a thread of this process sleeps.
inline bool asleep(int thread_id) {
    std::ifstream file("/proc/self/task/" + std::to_string(thread_id) + "/stat");
    std::string number, name, state;
    file >> number >> name >> state;
    return state == "S";
}

} // namespace wakesurf::tests
