// What the allocator keeps of memory that was freed. The program's allocator is jemalloc: its threads seldom
// wait for each other, as they do for the few arenas that keep the C library's small enough, and it returns
// freed pages within a fraction of a second.
#pragma once

namespace wakesurf::server {

/// To the system, in programs that are linked without jemalloc (tests, sanitizers); jemalloc does it by
/// itself. At most four times a second, more often nothing happens: it costs some ms. Thread safety: from
/// any thread.
void give_back_spare_heap();

} // namespace wakesurf::server
