#include "server/data/bricks/job_keeper.hpp"

#include "server/base/log_text.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <string>
#include <utility>

namespace wakesurf::server {

using core::Error;
using core::Result;

Result<bool> JobKeeper::tend() {
    listen();
    const Time now = options_.wall().now();
    if (!job_)
        return now < next_start_ ? Result<bool>(false) : start().map([] { return false; });
    if (talk_)
        return false;
    if (auto came = let_in(); !came || *came)
        return came;
    if (job_->ended())
        return core::fail(Error::Code::Io, "the job ended before it was there",
                          "its own words are above");
    if (now - started_ >= options_.coming)
        return core::fail(Error::Code::Io, "the job does not come");
    return false;
}

Result<void> JobKeeper::start() {
    auto opened = LocalDoor::open();
    if (!opened)
        return tl::unexpected(opened.error());
    door_.emplace(std::move(*opened));
    std::vector<std::string> words = options_.words;
    words.insert(words.end(), {options_.program.string(), options_.store.string(), "--socket",
                               door_->path().string()});
    if (options_.memory > 0)
        words.insert(words.end(), {"--memory", std::to_string(options_.memory)});
    auto begun = BricksJob::start(std::move(words));
    if (!begun)
        return tl::unexpected(begun.error());
    started_ = options_.wall().now();
    job_ = std::move(*begun);
    return {};
}

void JobKeeper::listen() {
    if (job_)
        for (const std::string& line : job_->lines())
            if (!line.empty())
                spdlog::info("event=bricks_job message={}", log_value(line));
}

Result<bool> JobKeeper::let_in() {
    if (!guest_)
        if (auto came = door_->let_in())
            guest_ = std::move(*came);
    if (!guest_)
        return false;
    auto met = JobTalk::meet(*guest_, wanted_);
    if (!met)
        return tl::unexpected(met.error());
    if (!*met)
        return false;
    guest_.reset();
    door_.reset(); // nobody else comes, and a server that is killed leaves nothing behind
    talk_ = std::move(**met);
    rest_ = options_.first_rest;
    spdlog::info("event=bricks_job_there ranks={} bricks={}", talk_->ranks(), talk_->held());
    return true;
}

void JobKeeper::end() {
    guest_.reset();
    talk_.reset(); // the job notices, and ends
    listen();
    job_.reset();
    door_.reset();
    next_start_ = options_.wall().now() + rest_;
    rest_ = std::min(2 * rest_, options_.longest_rest);
}

void JobKeeper::watch(std::vector<pollfd>& files) const {
    if (job_ && !job_->ended() && job_->output() >= 0)
        files.push_back({job_->output(), POLLIN, 0});
    if (talk_)
        files.push_back({talk_->socket(), POLLIN, 0});
    else if (guest_)
        files.push_back({guest_->get(), POLLIN, 0});
    else if (door_)
        files.push_back({door_->file(), POLLIN, 0});
}

JobKeeper::Time JobKeeper::due() const {
    return !job_ ? next_start_ : !talk_ ? started_ + options_.coming : Time::max();
}

} // namespace wakesurf::server
