#include "server/remote/web/answer_checks.hpp"

#include <algorithm>

namespace wakesurf::server {

using core::Error;
using core::fail;
using core::Result;

namespace {

constexpr int partial = 206;
constexpr int nothing_there = 416;

bool has_bytes(const HttpAnswer& answer) {
    return answer.status == 200 || answer.status == partial;
}

bool is_page(const HttpAnswer& answer) {
    return answer.content_type.starts_with("text/html") ||
           answer.content_type.starts_with("application/xhtml");
}

/// Returns the printable part of an address that a server sends, for messages.
std::string printable(std::string_view text) {
    constexpr std::size_t most = 200;
    std::string out(text.substr(0, most));
    std::replace_if(
        out.begin(), out.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return out;
}

tl::unexpected<Error> no_ranges(const std::string& address) {
    return fail(Error::Code::Io,
                address + ": the server answers with the whole file where a part was asked for",
                "serve the store from a server that knows byte ranges, as nginx, Apache and object "
                "stores do");
}

} // namespace

bool comes_again(const HttpAnswer& answer) {
    constexpr int passing[] = {408, 425, 429, 500, 502, 503, 504};
    if (std::find(std::begin(passing), std::end(passing), answer.status) != std::end(passing))
        return true;
    if (answer.status != partial || !answer.range || !answer.range->first || answer.longer)
        return false;
    const auto& range = *answer.range;
    return *range.last >= *range.first && answer.bytes < *range.last - *range.first + 1;
}

Result<void>
check_status(const HttpRequest& request, const HttpAnswer& answer, const std::string& times) {
    const std::string& address = request.address;
    const int status = answer.status;
    if (has_bytes(answer) && is_page(answer))
        return fail(Error::Code::Corrupt,
                    address + ": the server answers with a web page instead of the file",
                    "open the address in a browser: it may want a login");
    if (status == partial && !times.empty())
        return fail(Error::Code::Io, address + ": the answer ends before it should" + times,
                    "try again when the server can be reached");
    if (has_bytes(answer) ||
        (status == nothing_there && request.range && request.range->first == 0))
        return {};
    if (status == 412)
        return changed(address);
    const std::string said = address + ": the server answered " + std::to_string(status) + times;
    if (status == 404 || status == 410)
        return fail(Error::Code::NotFound, address + " is not there",
                    "a store's address is that of its folder, in which store.json is");
    if (status == 401 || status == 403)
        return fail(Error::Code::Io, said + ": it lets nobody in, or not with these credentials",
                    "set WAKESURF_HTTP_TOKEN, or WAKESURF_HTTP_S3_REGION and the keys of AWS; an "
                    "object store also answers so for what is not there");
    if (status >= 300 && status < 400)
        return fail(Error::Code::Io,
                    said + " and leads elsewhere" +
                        (answer.location.empty() ? "" : ": " + printable(answer.location)),
                    "give the address it leads to: redirects are not followed");
    return fail(Error::Code::Io, said, comes_again(answer) ? "try again later" : "");
}

Result<std::uint64_t> size_told(const HttpRequest& request, const HttpAnswer& answer) {
    const std::string& address = request.address;
    if (answer.status == nothing_there) {
        if (answer.range && answer.range->total == 0)
            return 0;
        return fail(Error::Code::Io, address + ": the server knows no beginning of it");
    }
    if (request.head) {
        if (answer.content_length)
            return *answer.content_length;
        return fail(Error::Code::Io, address + ": the server does not say how large it is");
    }
    if (answer.status == partial) {
        if (!answer.range)
            return fail(Error::Code::Io, address + ": the server does not say which part it sends");
        const std::uint64_t size = answer.range->total;
        const HttpRequest fitting{
            address, false, HttpRange{0, std::min(size, request.range->count)}, {}};
        return check_part(fitting, answer, size).map([&] { return size; });
    }
    if (answer.longer)
        return no_ranges(address);
    return answer.bytes;
}

Result<void> check_part(const HttpRequest& request, const HttpAnswer& answer, std::uint64_t size) {
    const HttpRange& asked = *request.range;
    const bool all = asked.first == 0 && asked.count == size;
    if (answer.status == 200 && !all)
        return no_ranges(request.address);
    if (answer.status == 200) {
        if (answer.bytes == size && !answer.longer)
            return {};
    } else if (const auto& range = answer.range; range && range->first) {
        if (range->total != size)
            return changed(request.address);
        if (*range->first == asked.first && *range->last == asked.first + asked.count - 1 &&
            answer.bytes == asked.count && !answer.longer)
            return {};
    }
    return fail(Error::Code::Corrupt,
                request.address + ": the server sends another part than was asked for");
}

tl::unexpected<Error> changed(const std::string& address) {
    return fail(Error::Code::Corrupt, address + " has changed since it was opened",
                "start again to use what is there now");
}

} // namespace wakesurf::server
