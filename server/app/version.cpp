#include "server/app/version.hpp"

#include "protocol/api/openrpc.hpp"
#include "protocol/api/session_file.hpp"
#include "protocol/wire/mesh_frame.hpp"
#include "server/sessions/journal/state_layout.hpp"
#include "store/store_manifest.hpp"

#include <fmt/format.h>

namespace wakesurf::server {

std::string_view version_number() {
    return WAKESURF_VERSION;
}

std::string version_text(std::string_view commit) {
    return fmt::format("wakesurf {}\n"
                       "commit {}\n"
                       "API level {}\n"
                       "store format {}, {}\n"
                       "journal schema {}\n"
                       "session file {}\n"
                       "mesh frame {}",
                       version_number(), commit, protocol::api_level, store::store_format_version,
                       store::brick_format_version, state_layout, protocol::session_file_version,
                       protocol::frame_version);
}

} // namespace wakesurf::server
