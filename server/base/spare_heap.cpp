#include "server/base/spare_heap.hpp"

#include <malloc.h>

#include <atomic>
#include <chrono>
#include <cstddef>

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

} // namespace wakesurf::server
