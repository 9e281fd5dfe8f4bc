#include "server/remote/web/web_address.hpp"

#include "store/store_manifest.hpp"

#include <algorithm>

namespace wakesurf::server {

using core::Error;

namespace {

constexpr std::string_view separator = "://";

std::string_view scheme_of(std::string_view text) {
    const auto end = text.find(separator);
    return end == std::string_view::npos ? std::string_view() : text.substr(0, end);
}

bool without_slash(std::string& address) {
    if (!address.ends_with('/'))
        return false;
    address.pop_back();
    return true;
}

} // namespace

bool is_web_address(std::string_view text) {
    const auto scheme = scheme_of(text);
    return !scheme.empty() && std::all_of(scheme.begin(), scheme.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '+' || c == '-' || c == '.';
    });
}

bool is_on_the_web(const std::filesystem::path& folder) {
    return is_web_address(folder.string());
}

core::Result<std::string> store_address(std::string_view text) {
    const auto refused = [](std::string message, std::string hint) {
        return core::fail(Error::Code::InvalidArgument, std::move(message), std::move(hint));
    };
    const auto scheme = scheme_of(text);
    if (scheme != "https" && scheme != "http")
        return refused("addresses that begin with " + std::string(scheme) + ":// are not read",
                       "give https://HOST/PATH/STORE, or http://");
    std::string address(text);
    while (without_slash(address)) {
    }
    if (const auto name = "/" + std::string(store::manifest_file_name); address.ends_with(name))
        address.resize(address.size() - name.size());
    while (without_slash(address)) {
    }
    const std::string_view rest =
        std::string_view(address).substr(std::min(address.size(), scheme.size() + 3));
    const auto host = rest.substr(0, rest.find('/'));
    if (host.empty() || host == rest)
        return refused("the address names no store",
                       "give " + std::string(scheme) + "://HOST/PATH/STORE");
    if (host.find('@') != std::string_view::npos)
        return refused("the address contains a user name or a password, which everybody would see",
                       "leave it out, and set WAKESURF_HTTP_TOKEN");
    const bool plain = std::all_of(address.begin(), address.end(),
                                   [](char c) { return c > ' ' && c < 0x7f && c != '\\'; });
    if (!plain || address.find_first_of("?#") != std::string::npos ||
        (address + "/").find("/../") != std::string::npos)
        return refused(
            "the address of a store has no query, no fragment, no spaces and no `..`",
            "write spaces as %20; the files of the store are requested below this address");
    return address;
}

bool is_private_address(std::string_view address) {
    if (scheme_of(address) == "https")
        return true;
    const auto host = address.substr(std::min(address.size(), address.find(separator) + 3));
    const auto is = [&](std::string_view name) {
        return host.starts_with(name) &&
               (host.size() == name.size() || host[name.size()] == '/' || host[name.size()] == ':');
    };
    return is("127.0.0.1") || is("localhost") || is("[::1]");
}

} // namespace wakesurf::server
