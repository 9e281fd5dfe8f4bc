#include "server/app/server_address.hpp"

#include <algorithm>
#include <string_view>

namespace wakesurf::server {

namespace {

std::string token_of(std::string_view fragment) {
    constexpr std::string_view name = "token=";
    while (!fragment.empty()) {
        const auto end = std::min(fragment.find('&'), fragment.size());
        const std::string_view word = fragment.substr(0, end);
        if (word.starts_with(name))
            return std::string(word.substr(name.size()));
        fragment.remove_prefix(std::min(end + 1, fragment.size()));
    }
    return {};
}

} // namespace

std::string ServerAddress::authority() const {
    const std::string name = host.find(':') == std::string::npos ? host : "[" + host + "]";
    return name + ":" + port;
}

core::Result<ServerAddress> parse_server_address(const std::string& url) {
    const auto wrong =
        core::fail(core::Error::Code::InvalidArgument, "this is not the address of a server",
                   "give the one it printed: http://HOST:PORT/#token=...");
    ServerAddress out;
    std::string_view rest = url;
    if (rest.starts_with("https://"))
        out.tls = true;
    else if (!rest.starts_with("http://"))
        return wrong;
    rest.remove_prefix(out.tls ? 8 : 7);
    const auto hash = std::min(rest.find('#'), rest.size());
    out.token = token_of(rest.substr(std::min(hash + 1, rest.size())));
    rest = rest.substr(0, hash);
    while (rest.ends_with('/'))
        rest.remove_suffix(1);
    const auto slash = std::min(rest.find('/'), rest.size());
    out.prefix = rest.substr(slash);
    rest = rest.substr(0, slash);
    const auto printable = [](char c) { return c > ' ' && c < 0x7f && c != '?'; };
    if (!std::all_of(out.prefix.begin(), out.prefix.end(), printable))
        return wrong;
    const auto bracket = rest.starts_with('[') ? rest.find(']') : 0;
    if (bracket == std::string_view::npos)
        return wrong;
    const auto colon = rest.find(':', bracket);
    out.host = rest.substr(bracket == 0 ? 0 : 1, bracket == 0 ? colon : bracket - 1);
    out.port = colon == std::string_view::npos ? (out.tls ? "443" : "80")
                                               : std::string(rest.substr(colon + 1));
    const auto digit = [](char c) { return c >= '0' && c <= '9'; };
    if (out.host.empty() || out.port.empty() || out.port.size() > 5 ||
        !std::all_of(out.port.begin(), out.port.end(), digit))
        return wrong;
    return out;
}

} // namespace wakesurf::server
