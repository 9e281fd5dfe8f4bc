// Opens stores on the web, and Zarrs on a disk or on the web.
#include "core/base/disk.hpp"
#include "server/remote/remote_dataset.hpp"
#include "server/remote/web/curl_transport.hpp"
#include "server/remote/web/web_disk.hpp"
#include "server/remote/zarr/zarr_disk.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::server {

using core::Error;

namespace {

/// Returns the disk; opens nothing yet. Error: InvalidArgument, as open_disk.
core::Result<std::shared_ptr<const core::Disk>> web_disk_of(const std::filesystem::path& folder,
                                                            std::stop_token closing) {
    auto credentials = HttpCredentials::of_environment();
    if (credentials.any() && !is_private_address(folder.string()))
        return core::fail(Error::Code::InvalidArgument,
                          "credentials are not sent to an address that begins with http://",
                          "give the address with https://, or unset WAKESURF_HTTP_TOKEN and "
                          "WAKESURF_HTTP_S3_REGION");
    const auto is_of_a_line = [](const std::string& text) {
        return std::ranges::none_of(text, [](unsigned char c) { return c < ' ' || c == 0x7f; });
    };
    if (!is_of_a_line(credentials.token) || !is_of_a_line(credentials.session_token))
        return core::fail(
            Error::Code::InvalidArgument,
            "WAKESURF_HTTP_TOKEN or AWS_SESSION_TOKEN holds a line break, which would "
            "begin another header",
            "set it to the token alone");
    if (!credentials.s3_region.empty() && credentials.token.empty() &&
        (credentials.access_key.empty() || credentials.secret_key.empty()))
        return core::fail(Error::Code::InvalidArgument,
                          "WAKESURF_HTTP_S3_REGION is set, but there are no keys to sign with",
                          "set AWS_ACCESS_KEY_ID and AWS_SECRET_ACCESS_KEY");
    return std::make_shared<const WebDisk>(std::make_shared<CurlTransport>(std::move(credentials)),
                                           WebDisk::wait, std::move(closing));
}

} // namespace

core::Result<OpenDisk> open_remote(const std::filesystem::path& folder,
                                   std::uint64_t scalar_bytes,
                                   std::stop_token closing) {
    std::shared_ptr<const core::Disk> disk;
    if (!is_on_the_web(folder)) {
        disk = std::make_shared<const core::FolderDisk>(folder); // anybody's, unlike a store
    } else if (auto web = web_disk_of(folder, std::move(closing))) {
        disk = std::move(*web);
    } else {
        return tl::unexpected(web.error());
    }
    if (!is_zarr(folder))
        return OpenDisk{std::move(disk), std::nullopt};
    return ZarrDisk::open(folder, std::move(disk), scalar_bytes)
        .map([](const std::shared_ptr<const ZarrDisk>& zarr) {
            return OpenDisk{zarr, ChunkMemory{zarr->least_memory(), [zarr](std::size_t bytes) {
                                                  zarr->use_memory(bytes);
                                              }}};
        });
}

} // namespace wakesurf::server
