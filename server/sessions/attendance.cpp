#include "server/sessions/attendance.hpp"

#include <utility>

namespace wakesurf::server {

void Attendance::seen() {
    seen_ = clock_.now();
    if (!look_)
        look_later();
    if (std::exchange(empty_, false))
        events_.back();
}

std::shared_ptr<void> Attendance::stay() {
    seen();
    if (auto held = stay_.lock())
        return held;
    auto held = std::make_shared<int>();
    stay_ = held;
    return held;
}

void Attendance::look_later() {
    look_ = loop_.after(look_every, [this] { look(); });
}

void Attendance::look() {
    if (!stay_.expired() || events_.somebody())
        seen_ = clock_.now();
    if (clock_.now() - seen_ < nobody)
        return look_later();
    look_.reset();
    empty_ = true;
    events_.empty();
}

} // namespace wakesurf::server
