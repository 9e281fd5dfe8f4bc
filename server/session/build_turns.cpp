#include "server/session/build_turns.hpp"

#include <deque>
#include <utility>

namespace wakesurf::server {

struct BuildTurns::State : std::enable_shared_from_this<State> {
    State(Loop& on, std::size_t most) : loop(on), at_once(most) {}

    /// From the loop: whoever drops a ticket is in the middle of something.
    void look() {
        if (!std::exchange(looking, true))
            loop.post([weak = weak_from_this()] {
                if (const auto self = weak.lock())
                    self->begin_next();
            });
    }

    void begin_next() {
        looking = false;
        while (running < at_once && !waiting.empty()) {
            const Begin begin = std::move(waiting.front());
            waiting.pop_front();
            ++running;
            begin(std::shared_ptr<void>(nullptr, [weak = weak_from_this()](void*) {
                if (const auto self = weak.lock()) {
                    --self->running;
                    self->look();
                }
            }));
        }
    }

    Loop& loop;
    std::size_t at_once;
    std::size_t running = 0;
    bool looking = false;
    std::deque<Begin> waiting;
};

BuildTurns::BuildTurns(Loop& loop, std::size_t at_once)
    : state_(std::make_shared<State>(loop, at_once)) {}

void BuildTurns::queue(Begin begin) {
    state_->waiting.push_back(std::move(begin));
    state_->look();
}

} // namespace wakesurf::server
