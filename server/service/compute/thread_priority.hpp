// How a thread stands beside the others of the machine, and how much of the processor it has had.
#pragma once

#include <thread>

namespace wakesurf::server {

/// What is added to the priority of threads that give way. Next to a thread that answers a person they have a third and a tenth of its time.
constexpr int crowd_niceness = 5, long_niceness = 10;

/// As the system numbers it.
int own_thread_id();

/// That thread gives way to those that answer a person, for good. Where the kernel refuses, all run alike.
/// @param thread  of this process; 0: the calling one
void step_back(int niceness, int thread = 0);

/// The calling thread works for moments and is waited for: it begins sooner beside threads that work for long, and has no more of the
/// processor for it. Linux 6.12 and later; elsewhere nothing changes. (sched(7), sched_setattr(2): sched_runtime of SCHED_OTHER)
void ask_for_short_slices();

/// s that the calling thread has had a processor.
double processor_seconds();

/// The same of another; 0 once it has ended. REQUIRES: it is not joined meanwhile.
double processor_seconds(std::thread::native_handle_type thread);

} // namespace wakesurf::server
