// A pending read of a brick, between the job and the files.
#pragma once

#include "core/dataset/brick_source.hpp"

#include <cstddef>
#include <memory>
#include <stop_token>
#include <utility>
#include <vector>

namespace wakesurf::server {

/// Holds the reads of one call.
struct AskedReads {
    std::vector<core::BrickRead> reads;
    std::stop_token stop;
    core::BrickSource::Done done;
};

/// Names one of them.
struct WaitingRead {
    std::shared_ptr<AskedReads> asked;
    std::size_t index = 0;

    const core::BrickRead& read() const { return asked->reads[index]; }

    void tell(core::Result<void> outcome) const { asked->done(index, std::move(outcome)); }

    /// Ends it without a brick.
    void cancel() const {
        tell(core::fail(core::Error::Code::Cancelled, "reading the brick was cancelled"));
    }
};

} // namespace wakesurf::server
