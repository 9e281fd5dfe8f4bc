#include "server/rpc/lattice_json.hpp"

#include <nlohmann/json.hpp>

namespace wakesurf::server {

nlohmann::json lattice_json(const protocol::Lattice& lattice) {
    return {{"origin", {lattice.origin.x, lattice.origin.y, lattice.origin.z}},
            {"step", lattice.step},
            {"bits", lattice.bits}};
}

} // namespace wakesurf::server
