// Takes the place of open_remote.cpp in a build with WAKESURF_REMOTE=OFF.
#include "server/remote/remote_dataset.hpp"

namespace wakesurf::server {

core::Result<OpenDisk> open_remote(const std::filesystem::path& /*folder*/,
                                   std::uint64_t /*scalar_bytes*/,
                                   std::stop_token /*closing*/) {
    return core::fail(core::Error::Code::Unsupported,
                      "this build reads neither Zarr nor stores on the web",
                      "build with -DWAKESURF_REMOTE=ON, or copy the data to this machine and "
                      "import them");
}

} // namespace wakesurf::server
