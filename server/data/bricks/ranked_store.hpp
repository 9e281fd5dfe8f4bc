// A store whose bricks may come from an MPI job: everything else is the reader's.
#pragma once

#include "core/dataset/time_step_source.hpp"
#include "server/data/bricks/rank_bricks.hpp"
#include "store/store_reader.hpp"

#include <memory>

namespace wakesurf::server {

class RankedStore final : public core::TimeStepSource {
  public:
    /// REQUIRES: the store is in bricks.
    RankedStore(std::shared_ptr<const store::StoreReader> reader, RankBricks::Options options);

    const core::Grid& grid() const override { return reader_->grid(); }

    const core::SolidMask& mask() const override { return reader_->mask(); }

    const std::vector<double>& times() const override { return reader_->times(); }

    bool ready(std::size_t index) const override { return reader_->ready(index); }

    std::size_t bytes_per_step() const override { return reader_->bytes_per_step(); }

    core::Result<std::shared_ptr<const core::TimeStep>> load(std::size_t index,
                                                             std::stop_token stop) const override {
        return reader_->load(index, std::move(stop));
    }

    const core::BrickSource* bricks() const override { return &ranks_; }

    void let_go() const override { reader_->let_go(); }

    RankBricks& ranks() { return ranks_; }

    const RankBricks& ranks() const { return ranks_; }

  private:
    std::shared_ptr<const store::StoreReader> reader_;
    RankBricks ranks_; ///< destroyed first: it reads from the reader
};

} // namespace wakesurf::server
