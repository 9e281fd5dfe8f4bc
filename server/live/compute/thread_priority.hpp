// Sets the priority of a thread beside others of the machine, and measures its processor time.
#pragma once

#include <thread>

namespace wakesurf::server {

/// The niceness of threads that yield. Beside a thread that answers a client they get a third and a tenth
/// of its time.
constexpr int crowd_niceness = 5, long_niceness = 10;

/// Returns the number that the system gives the calling thread.
int own_thread_id();

/// Lowers the priority of a thread for good. Where the kernel refuses, all threads have the same.
/// @param thread  one of this process; 0: the calling one
void step_back(int niceness, int thread = 0);

/// The calling thread works for moments and is waited for: it begins sooner beside threads that work for
/// long, and has no more of the processor for it. Linux 6.12 and later; elsewhere nothing changes.
/// (sched(7), sched_setattr(2): sched_runtime of SCHED_OTHER)
void ask_for_short_slices();

/// Returns the processor time of the calling thread, in s.
double processor_seconds();

/// Returns that of another thread; 0 once it has ended. REQUIRES: it is not joined meanwhile.
double processor_seconds(std::thread::native_handle_type thread);

} // namespace wakesurf::server
