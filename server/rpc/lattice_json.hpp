// The lattice of a dataset's frames, as dataset.describe and surface.subscribe tell it.
#pragma once

#include "protocol/wire/lattice.hpp"

#include <nlohmann/json_fwd.hpp>

namespace wakesurf::server {

nlohmann::json lattice_json(const protocol::Lattice& lattice);

} // namespace wakesurf::server
