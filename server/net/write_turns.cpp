#include "server/net/write_turns.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::server {

void WriteTurns::ask(std::weak_ptr<Writer> writer) {
    waiting_.push_back(std::move(writer));
    go_on();
}

void WriteTurns::go_on() {
    if (!waiting_.empty() && !std::exchange(posted_, true))
        post_([this] { turn(); });
}

void WriteTurns::turn() {
    posted_ = false;
    for (std::size_t left = std::min(at_once, waiting_.size()); left > 0; --left) {
        const auto writer = waiting_.front().lock();
        waiting_.pop_front();
        if (writer)
            writer->write_turn();
    }
    go_on();
}

} // namespace wakesurf::server
