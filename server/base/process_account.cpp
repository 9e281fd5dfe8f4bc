#include "server/base/process_account.hpp"

#include "core/base/machine_memory.hpp"

#include <malloc.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>

// A function of jemalloc; null if the program is linked without it.
extern "C" {
[[gnu::weak]] int
mallctl(const char* name, void* old, std::size_t* old_size, void* value, std::size_t size);

// jemalloc reads this when the process starts. Its own threads return pages, most of them 0.1 s after they
// were freed. That is soon enough: asking for all of them at once takes 20 to 140 ms, and beside hostile
// editors small work waited for that 28 times a minute, 52 ms on average.
extern const char* malloc_conf;
const char* malloc_conf = "background_thread:true,dirty_decay_ms:100,muzzy_decay_ms:0";
}

namespace wakesurf::server {

namespace {

constexpr std::chrono::milliseconds rest{250};

} // namespace

void give_back_spare_heap() {
    if (mallctl != nullptr)
        return;
    static std::atomic<std::chrono::steady_clock::rep> last{0};
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    auto before = last.load();
    if (now - std::chrono::steady_clock::duration(before) < rest ||
        !last.compare_exchange_strong(before, now.count()))
        return;
    ::malloc_trim(0);
}

namespace {

/// The default's share of the memory, in percent.
constexpr std::uint64_t part = 60;
constexpr std::size_t without_proc = std::size_t{4} << 30;

} // namespace

std::size_t default_memory() {
    const std::uint64_t granted = core::granted_memory();
    return granted == 0 ? without_proc : static_cast<std::size_t>(granted / 100 * part);
}

ProcessAccount::ProcessAccount(std::size_t budget)
    : account_(budget == 0 ? default_memory() : budget),
      spare_heap_(account_.on_need(core::ReclaimOrder::SpareHeap,
                                   [](std::size_t) { give_back_spare_heap(); })) {
    account_.watch([] { return static_cast<std::size_t>(core::resident_memory()); });
}

bool ProcessAccount::too_much() const {
    account_.measure();
    return account_.used() > account_.budget();
}

} // namespace wakesurf::server
