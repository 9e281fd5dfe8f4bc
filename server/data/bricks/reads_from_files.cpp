#include "server/data/bricks/reads_from_files.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::server {

ReadsFromFiles::~ReadsFromFiles() {
    std::unique_lock lock(mutex_);
    none_left_.wait(lock, [&] { return left_ == 0; });
}

void ReadsFromFiles::begin(std::vector<WaitingRead> which) {
    {
        const std::scoped_lock lock(mutex_);
        left_ += which.size();
        count_ += which.size();
    }
    while (!which.empty()) {
        const auto asked = which.front().asked;
        const auto rest_of = std::stable_partition(
            which.begin(), which.end(), [&](const auto& each) { return each.asked == asked; });
        std::vector<core::BrickRead> reads;
        std::vector<std::size_t> indices;
        for (auto each = which.begin(); each != rest_of; ++each) {
            reads.push_back(each->read());
            indices.push_back(each->index);
        }
        which.erase(which.begin(), rest_of);
        files_.read(
            std::move(reads), asked->stop,
            [this, asked, indices = std::move(indices)](std::size_t i, core::Result<void> outcome) {
                asked->done(indices[i], std::move(outcome));
                const std::scoped_lock lock(mutex_);
                if (--left_ == 0)
                    none_left_.notify_all();
            });
    }
}

std::uint64_t ReadsFromFiles::count() const {
    const std::scoped_lock lock(mutex_);
    return count_;
}

} // namespace wakesurf::server
