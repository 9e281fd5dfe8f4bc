#include "server/service/web/dataset_disk.hpp"

#include "server/service/web/curl_transport.hpp"
#include "server/service/web/web_address.hpp"
#include "server/service/web/web_disk.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::server {

using core::Error;

bool is_on_the_web(const std::filesystem::path& folder) {
    return is_web_address(folder.string());
}

core::Result<std::shared_ptr<const core::Disk>> disk_of(const std::filesystem::path& folder,
                                                        std::stop_token closing) {
    if (!is_on_the_web(folder))
        return std::make_shared<const core::PosixDisk>();
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

} // namespace wakesurf::server
