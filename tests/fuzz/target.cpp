#include "tests/fuzz/target.hpp"

#include "tests/fuzz/targets/all.hpp"

#include <cstdio>
#include <cstdlib>

namespace wakesurf::fuzz {

const std::vector<Target>& targets() {
    static const std::vector<Target> all{
        {"mesh_decoder", mesh_decoder, mesh_decoder_seeds},
        {"json_rpc", json_rpc, json_rpc_seeds, true},
        {"settings", settings, settings_seeds, true},
        {"records", records, records_seeds, true},
        {"journal_rows", journal_rows, journal_rows_seeds, true},
        {"store_manifest", store_manifest, store_manifest_seeds, true},
        {"command_line_text", command_line_text, command_line_text_seeds},
        {"gate", gate, gate_seeds},
        {"ensight", ensight, ensight_seeds},
        {"plot3d", plot3d, plot3d_seeds},
        {"netcdf", netcdf, netcdf_seeds},
    };
    return all;
}

void demand(bool holds, std::string_view sentence) {
    if (holds)
        return;
    std::fprintf(stderr, "broken: %.*s\n", static_cast<int>(sentence.size()), sentence.data());
    std::abort();
}

} // namespace wakesurf::fuzz
