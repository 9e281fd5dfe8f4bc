// The catalogue's datasets, as sessions and methods see them.
#pragma once

#include "server/data/dataset_catalogue.hpp"
#include "server/data/datasets.hpp"

namespace wakesurf::server {

class CatalogueDatasets final : public Datasets {
  public:
    explicit CatalogueDatasets(const DatasetCatalogue& catalogue) : catalogue_(catalogue) {}

    std::vector<std::string> ids() const override;
    core::Result<OpenDataset> open(const std::string& id) const override;

  private:
    const DatasetCatalogue& catalogue_;
};

} // namespace wakesurf::server
