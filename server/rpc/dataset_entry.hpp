// A dataset's place in dataset.list and dataset.patched.
#pragma once

#include "server/service/catalogue/dataset_catalogue.hpp"

#include <nlohmann/json_fwd.hpp>

namespace wakesurf::server {

nlohmann::json dataset_entry(const DatasetStatus& status);

} // namespace wakesurf::server
