// A server without any data.
#pragma once

#include "server/data/datasets.hpp"

#include <string>
#include <vector>

namespace wakesurf::tests {

class NoDatasets final : public server::Datasets {
  public:
    std::vector<std::string> ids() const override { return {}; }

    core::Result<server::OpenDataset> open(const std::string&) const override {
        return core::fail(core::Error::Code::NotFound, "there are none");
    }
};

} // namespace wakesurf::tests
