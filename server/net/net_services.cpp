#include "server/net/net_services.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::server {

void WriteScheduler::ask(std::weak_ptr<Writer> writer) {
    if (waiting_.empty() && !posted_)
        since_ = clock_.now();
    waiting_.push_back(std::move(writer));
    go_on();
}

void WriteScheduler::go_on() {
    if (!waiting_.empty() && !std::exchange(posted_, true))
        post_([this] { turn(); });
}

void WriteScheduler::turn() {
    const auto start = clock_.now();
    const auto share = start - since_;
    std::size_t left = waiting_.size(); // a writer that asks again waits for the next post
    do {
        for (std::size_t some = std::min(at_once, left); some > 0; --some, --left) {
            const auto writer = waiting_.front().lock();
            waiting_.pop_front();
            if (writer)
                writer->write_turn();
        }
        since_ = clock_.now();
    } while (left > 0 && since_ - start < share);
    posted_ = false;
    go_on();
}

} // namespace wakesurf::server
