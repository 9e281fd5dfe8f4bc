// The served part of a Zarr: its velocity and scalars, and the manifest that a store of them would have.
#pragma once

#include "server/remote/zarr/zarr_axes.hpp"
#include "store/store_manifest.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace wakesurf::server {

/// Names one number a node: of an array, or of one component of it.
struct ZarrPart {
    std::size_t array = 0; ///< which of ZarrDataset::arrays
    std::uint64_t component = 0;
};

struct ZarrDataset {
    std::vector<ZarrArray> arrays;              ///< those that are served
    std::vector<ZarrAxes> axes;                 ///< of each of them
    std::vector<std::vector<ZarrPart>> columns; ///< the velocity's x, y and z; then each scalar
    store::StoreManifest manifest;              ///< of bricks without checksums
    core::Grid grid;                            ///< of all of them
};

/// Describes a Zarr with the velocity of choose_zarr_velocity. Scalars on the same nodes are included if two
/// time-steps of four of them fit into `scalar_bytes`, the memory kept for them; the note lists those left
/// out. Error: as choose_zarr_velocity and zarr_coordinates; Unsupported for units that do not fit each
/// other.
core::Result<ZarrDataset> describe_zarr(const std::string& name,
                                        const ZarrGroup& group,
                                        const ChunkObjects& objects,
                                        std::uint64_t scalar_bytes);

} // namespace wakesurf::server
