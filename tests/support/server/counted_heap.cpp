#include "tests/support/server/counted_heap.hpp"

#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

namespace wakesurf::tests {

namespace {

// Smaller pieces are counted too, but compared only with the next large one, which keeps the cost low.
constexpr std::size_t large = 4'096;

std::atomic<std::size_t> live{0};
std::atomic<const core::MemoryAccount*> watched{nullptr};
std::atomic<std::size_t> at_start{0}, most_held{0}, most_beyond{0}, most_in_account{0};
thread_local bool looking = false;

void raise(std::atomic<std::size_t>& most, std::size_t to) {
    for (auto now = most.load(); now < to && !most.compare_exchange_weak(now, to);) {
    }
}

void look() {
    const core::MemoryAccount* account = watched;
    if (account == nullptr || looking)
        return;
    looking = true;
    const std::size_t held = live - std::min(live.load(), at_start.load());
    const std::size_t told = account->used();
    raise(most_held, held);
    raise(most_in_account, told);
    raise(most_beyond, held - std::min(held, told));
    looking = false;
}

void* taken(void* piece, std::size_t bytes) {
    if (piece == nullptr)
        throw std::bad_alloc();
    live += ::malloc_usable_size(piece);
    if (bytes >= large)
        look();
    return piece;
}

void given_back(void* piece) noexcept {
    if (piece != nullptr)
        live -= ::malloc_usable_size(piece);
    std::free(piece);
}

} // namespace

std::size_t held_on_heap() {
    return live;
}

CountedHeap::CountedHeap(const core::MemoryAccount& account) {
    at_start = live.load();
    most_held = most_beyond = most_in_account = 0;
    watched = &account;
}

CountedHeap::~CountedHeap() {
    watched = nullptr;
}

std::size_t CountedHeap::most() const {
    return most_held;
}

std::size_t CountedHeap::most_untold() const {
    return most_beyond;
}

std::size_t CountedHeap::most_told() const {
    return most_in_account;
}

} // namespace wakesurf::tests

using wakesurf::tests::given_back;
using wakesurf::tests::taken;

void* operator new(std::size_t bytes) {
    return taken(std::malloc(bytes), bytes);
}

void* operator new(std::size_t bytes, std::align_val_t alignment) {
    return taken(std::aligned_alloc(static_cast<std::size_t>(alignment), bytes), bytes);
}

void operator delete(void* piece) noexcept {
    given_back(piece);
}

void operator delete(void* piece, std::size_t) noexcept {
    given_back(piece);
}

void operator delete(void* piece, std::align_val_t) noexcept {
    given_back(piece);
}

void operator delete(void* piece, std::size_t, std::align_val_t) noexcept {
    given_back(piece);
}
