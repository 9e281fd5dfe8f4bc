// The datasets surfaces can be built from, as sessions see them.
#pragma once

#include "core/base/result.hpp"
#include "core/dataset/dataset_info.hpp"
#include "core/dataset/time_step_cache.hpp"
#include "core/field/flow.hpp"
#include "core/surface/level/level_source.hpp"
#include "protocol/wire/lattice.hpp"
#include "server/data/dataset_catalogue.hpp"
#include "store/store_reader.hpp"
#include "store/store_scalars.hpp"

#include <memory>
#include <string>
#include <vector>

namespace wakesurf::server {

struct OpenDataset {
    core::DatasetInfo info;
    protocol::Lattice lattice;
    std::shared_ptr<const core::Flow> flow;
    std::shared_ptr<core::TimeStepCache> cache{};         ///< null for a built-in flow
    std::shared_ptr<const store::StoreReader> store{};    ///< null for a built-in flow
    std::shared_ptr<const store::StoreScalars> scalars{}; ///< of the store; likewise
    std::shared_ptr<const core::LevelSource> levels{};    ///< the same
    std::string flow_text{}; ///< of a built-in flow, behind `flow:`; empty: a store
};

/// Loop thread only; nothing here waits for a disk.
class Datasets {
  public:
    virtual ~Datasets() = default;

    /// Lists the ids of those that can be opened now, in catalogue order.
    virtual std::vector<std::string> ids() const = 0;

    /// Error: NotFound; what importing failed with; Io while not a single time-step has been imported.
    virtual core::Result<OpenDataset> open(const std::string& id) const = 0;
};

/// The values of a dataset are others than when `before` was open, or there are none any more.
bool replaced_since(const Datasets& datasets,
                    const std::string& id,
                    const std::shared_ptr<const store::StoreReader>& before);

/// The catalogue's datasets, as sessions and methods see them.
class CatalogueDatasets final : public Datasets {
  public:
    explicit CatalogueDatasets(const DatasetCatalogue& catalogue) : catalogue_(catalogue) {}

    std::vector<std::string> ids() const override;
    core::Result<OpenDataset> open(const std::string& id) const override;

  private:
    const DatasetCatalogue& catalogue_;
};

} // namespace wakesurf::server
