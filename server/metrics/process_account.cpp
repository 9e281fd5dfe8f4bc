#include "server/metrics/process_account.hpp"

#include "core/base/machine_memory.hpp"

#include <malloc.h>

#include <atomic>
#include <chrono>
#include <cstdint>

namespace wakesurf::server {

namespace {

/// Of what there is, in percent.
constexpr std::uint64_t part = 60;
constexpr std::size_t without_proc = std::size_t{4} << 30;

// Giving freed memory back costs some ms while others wait for the allocator.
constexpr std::chrono::milliseconds rest{250};

void make_allocator_frugal() {
#ifdef __GLIBC__
    // Each thread's own arena would keep what it once took; large arrays go back to the system as soon as they are freed, however large
    // those freed before were.
    ::mallopt(M_ARENA_MAX, 4);
    ::mallopt(M_MMAP_THRESHOLD, 512 << 10);
    ::mallopt(M_TRIM_THRESHOLD, 4 << 20);
#endif
}

void give_back_spare_heap() {
#ifdef __GLIBC__
    static std::atomic<std::chrono::steady_clock::rep> last{0};
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    auto before = last.load();
    if (now - std::chrono::steady_clock::duration(before) < rest ||
        !last.compare_exchange_strong(before, now.count()))
        return;
    ::malloc_trim(0);
#endif
}

} // namespace

std::size_t default_memory() {
    const std::uint64_t granted = core::granted_memory();
    return granted == 0 ? without_proc : static_cast<std::size_t>(granted / 100 * part);
}

ProcessAccount::ProcessAccount(std::size_t budget)
    : account_(budget == 0 ? default_memory() : budget),
      spare_heap_(account_.on_need(core::GiveBack::SpareHeap,
                                   [](std::size_t) { give_back_spare_heap(); })) {
    make_allocator_frugal();
    account_.watch([] { return static_cast<std::size_t>(core::resident_memory()); });
}

bool ProcessAccount::too_much() const {
    account_.look();
    return account_.used() > account_.budget();
}

} // namespace wakesurf::server
