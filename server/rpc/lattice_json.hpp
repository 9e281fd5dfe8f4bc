// The lattice of a dataset's frames, as dataset.describe and surface.subscribe tell it.
#pragma once

#include "protocol/lattice.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

inline nlohmann::json lattice_json(const protocol::Lattice& lattice) {
    return {{"origin", {lattice.origin.x, lattice.origin.y, lattice.origin.z}},
            {"step", lattice.step},
            {"bits", lattice.bits}};
}

} // namespace wakesurf::server
