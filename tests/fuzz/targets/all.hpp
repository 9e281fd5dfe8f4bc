// Every target; each has a file of its name here.
#pragma once

#include "tests/fuzz/target.hpp"

namespace wakesurf::fuzz {

extern const Target mesh_decoder_target;
extern const Target json_rpc_target;
extern const Target settings_target;
extern const Target records_target;
extern const Target journal_rows_target;
extern const Target store_manifest_target;
extern const Target brick_files_target;
extern const Target command_line_text_target;
extern const Target gate_target;
extern const Target ensight_target;
extern const Target plot3d_target;
extern const Target netcdf_target;
extern const Target zarr_metadata_target;

} // namespace wakesurf::fuzz
