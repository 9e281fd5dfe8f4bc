#include "server/live/memory_reclaim.hpp"

#include <algorithm>
#include <atomic>
#include <utility>

namespace wakesurf::server {

struct MemoryReclaim::State : std::enable_shared_from_this<State> {
    State(Loop& on, const core::MemoryAccount& of, Surfaces all)
        : loop(on), account(of), surfaces(std::move(all)) {}

    /// Asks for memory, from any thread. @param more  bytes beyond those that are free
    void ask(std::size_t more) {
        const std::size_t bytes = account.free() + more;
        std::size_t before = wanted.load();
        while (before < bytes && !wanted.compare_exchange_weak(before, bytes)) {
        }
        if (!asked.exchange(true))
            loop.post([weak = weak_from_this()] {
                if (const auto self = weak.lock())
                    self->give();
            });
    }

    void give() {
        asked = false;
        const std::size_t bytes = wanted.exchange(0);
        if (!surfaces)
            return;
        auto all = surfaces();
        for (const auto& each : all)
            if (account.free() < bytes)
                each->ring()->keep_newest();
        std::erase_if(all, [](const auto& each) {
            return each->resting() || each->has_viewers() || each->busy();
        });
        std::ranges::stable_sort(all, {}, [](const auto& each) { return each->asked_for(); });
        for (const auto& each : all)
            if (account.free() < bytes)
                each->fall_back();
    }

    Loop& loop;
    core::MemoryAccount account;
    Surfaces surfaces;
    std::atomic<std::size_t> wanted{0};
    std::atomic<bool> asked{false};
};

MemoryReclaim::MemoryReclaim(Loop& loop, const core::MemoryAccount& account, Surfaces surfaces)
    : state_(std::make_shared<State>(loop, account, std::move(surfaces))),
      ticket_(account.on_need(core::ReclaimOrder::Surfaces,
                              [state = state_](std::size_t bytes) { state->ask(bytes); })) {}

MemoryReclaim::~MemoryReclaim() {
    ticket_.reset();
    state_->surfaces = nullptr;
}

} // namespace wakesurf::server
