#include "server/data/bricks/ranked_store.hpp"

#include <string_view>
#include <utility>

namespace wakesurf::server {

namespace {

WantedJob job_of(const store::StoreReader& reader) {
    const core::BrickLayout& layout = reader.bricks()->layout();
    WantedJob wanted;
    wanted.shape = {layout.dimensions(), layout.cells(), reader.times().size(),
                    3 * layout.nodes_per_brick()};
    wanted.contradicts = [&reader](std::string_view marks) {
        (void)reader.look_again(); // the job may know more time-steps
        return reader.contradicts(marks);
    };
    return wanted;
}

} // namespace

RankedStore::RankedStore(std::shared_ptr<const store::StoreReader> reader,
                         RankBricks::Options options)
    : reader_(std::move(reader)), ranks_(*reader_->bricks(), job_of(*reader_), std::move(options)) {
}

} // namespace wakesurf::server
