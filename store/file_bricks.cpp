#include "store/file_bricks.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace wakesurf::store {

using core::BrickRead;
using core::Error;

namespace {

constexpr std::size_t run_bytes = std::size_t{2} << 20;

} // namespace

struct FileBricks::Asked {
    std::vector<BrickRead> reads;
    std::vector<std::size_t> order; ///< of those that can be read: as they lie in the files
    std::stop_token stop;
    Done done;
};

bool FileBricks::there_is(const BrickRead& read) const {
    return read.step < bricks_.steps() && read.field < bricks_.columns() &&
           read.brick < layout().count();
}

std::string FileBricks::name_of(const BrickRead& read) const {
    return there_is(read) ? bricks_.name_of(read.field, read.step, read.brick)
                          : "brick " + std::to_string(read.brick) + " of time-step " +
                                std::to_string(read.step);
}

void FileBricks::read(std::vector<BrickRead> reads, std::stop_token stop, Done done) const {
    const auto asked =
        std::make_shared<Asked>(Asked{std::move(reads), {}, std::move(stop), std::move(done)});
    for (std::size_t i = 0; i < asked->reads.size(); ++i) {
        const BrickRead& one = asked->reads[i];
        if (!there_is(one))
            asked->done(i, core::fail(Error::Code::NotFound, "there is no " + name_of(one)));
        else if (one.to.size() != bricks_.values(one.field))
            asked->done(i,
                        core::fail(Error::Code::InvalidArgument,
                                   name_of(one) + ": there is room for another number of nodes"));
        else
            asked->order.push_back(i);
    }
    const auto where = [&](std::size_t i) {
        const BrickRead& one = asked->reads[i];
        return std::tuple(one.step, one.field, bricks_.place_of(one.brick));
    };
    std::sort(asked->order.begin(), asked->order.end(),
              [&](auto a, auto b) { return where(a) < where(b); });
    const auto& order = asked->order;
    const std::size_t share = (order.size() + readers_ - 1) / readers_;
    std::vector<core::WorkerThreads::Work> work;
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        const BrickRead& first = asked->reads[order[begin]];
        const std::size_t most = std::clamp<std::size_t>(
            run_bytes / bricks_.stored_bytes(first.field), 1, std::max<std::size_t>(1, share));
        auto next = where(order[begin]);
        while (end < order.size() && end - begin < most && where(order[end]) == next) {
            ++end;
            ++std::get<2>(next);
        }
        work.emplace_back(
            [this, asked, begin, end](bool ending) { read_run(*asked, begin, end, ending); });
    }
    threads_.add(std::move(work));
}

void FileBricks::read_run(const Asked& asked,
                          std::size_t begin,
                          std::size_t end,
                          bool ending) const {
    const auto which = std::span(asked.order).subspan(begin, end - begin);
    if (ending || asked.stop.stop_requested()) {
        for (const std::size_t i : which)
            asked.done(i, core::fail(Error::Code::Cancelled,
                                     "reading " + name_of(asked.reads[i]) + " was cancelled"));
        return;
    }
    std::vector<std::span<float>> to;
    for (const std::size_t i : which)
        to.push_back(asked.reads[i].to);
    const BrickRead& first = asked.reads[which.front()];
    bricks_.read(
        first.field, first.step, bricks_.place_of(first.brick), to,
        [&](std::size_t i, core::Result<void> outcome) {
            asked.done(which[i], std::move(outcome));
        },
        asked.stop);
}

} // namespace wakesurf::store
