// Parts of a dataset that several messages tell: its entry in dataset.list and dataset.patched, and the
// lattice of its frames.
#pragma once

#include "protocol/wire/lattice.hpp"
#include "server/data/dataset_catalogue.hpp"

#include <nlohmann/json_fwd.hpp>

namespace wakesurf::server {

/// Returns a DatasetEntry, as the description of the API has it.
nlohmann::json dataset_entry(const DatasetStatus& status);

/// Returns a Lattice.
nlohmann::json lattice_json(const protocol::Lattice& lattice);

} // namespace wakesurf::server
