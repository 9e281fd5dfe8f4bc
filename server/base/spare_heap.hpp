// Freed memory that the allocator keeps. The program's allocator is jemalloc: its threads seldom wait for
// each other, as they do for the few arenas that keep the C library's small enough, and it returns freed
// pages within a fraction of a second.
#pragma once

namespace wakesurf::server {

/// Returns it to the system in programs that are linked without jemalloc (tests, sanitizers); jemalloc does
/// so by itself. Does nothing if called again within 0.25 s: it costs some ms. Thread-safe.
void give_back_spare_heap();

} // namespace wakesurf::server
