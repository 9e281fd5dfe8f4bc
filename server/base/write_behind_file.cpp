#include "server/base/write_behind_file.hpp"

#include "server/base/private_file.hpp"

#include <utility>

namespace wakesurf::server {

void WriteBehindFile::put(std::string text, Done done) {
    {
        const std::lock_guard lock(mutex_);
        text_ = std::move(text);
        more_.clear();
        waiting_.push_back(std::move(done));
    }
    wake();
}

void WriteBehindFile::append(std::string text, Done done) {
    {
        const std::lock_guard lock(mutex_);
        more_ += text;
        waiting_.push_back(std::move(done));
    }
    wake();
}

void WriteBehindFile::wake() {
    if (!thread_.joinable())
        thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
    wake_.notify_one();
}

void WriteBehindFile::work(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (wake_.wait(lock, stop, [this] { return !waiting_.empty(); })) {
        const auto text = std::exchange(text_, std::nullopt);
        const std::string more = std::exchange(more_, {});
        auto waited = std::exchange(waiting_, {});
        lock.unlock();
        const auto written =
            text ? write_private_file(file_, *text + more) : append_private_file(file_, more);
        loop_.post([waited = std::move(waited), written] {
            for (const Done& done : waited)
                done(written);
        });
        lock.lock();
    }
}

} // namespace wakesurf::server
