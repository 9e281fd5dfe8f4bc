#include "tests/fuzz/target.hpp"

#include "tests/fuzz/targets/all.hpp"

namespace wakesurf::fuzz {

const std::vector<Target>& targets() {
    static const std::vector<Target> all{
        mesh_decoder_target,  json_rpc_target,       settings_target,    records_target,
        journal_rows_target,  store_manifest_target, brick_files_target, command_line_text_target,
        gate_target,          ensight_target,        plot3d_target,      netcdf_target,
        zarr_metadata_target,
    };
    return all;
}

} // namespace wakesurf::fuzz
