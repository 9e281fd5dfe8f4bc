#include "server/remote/web/web_disk.hpp"

#include "core/base/blocking_wait.hpp"
#include "core/base/either_stop.hpp"
#include "core/base/result.hpp"
#include "server/remote/web/http_transport.hpp"

#include <algorithm>
#include <condition_variable>
#include <cstdint>
#include <cstring>
#include <string>

namespace wakesurf::server {

/// Says that a retry may succeed: the server says so, or the connection ended early.
bool comes_again(const HttpAnswer& answer);

/// Checks the status. Error: NotFound; Corrupt for another object than was asked for, and for a web page; Io
/// for all else.
/// @param times  ", 5 times" after retries
core::Result<void>
check_status(const HttpRequest& request, const HttpAnswer& answer, const std::string& times);

/// Returns the size of the whole object, from the answer to a HEAD or for its beginning. Error: Io, Corrupt.
core::Result<std::uint64_t> size_told(const HttpRequest& request, const HttpAnswer& answer);

/// Checks that the answer has the part asked for, of an object of that size. Error: Io, Corrupt.
core::Result<void>
check_part(const HttpRequest& request, const HttpAnswer& answer, std::uint64_t size);

/// Returns the error for an object that has been replaced by another one.
tl::unexpected<core::Error> changed(const std::string& address);

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
                address + ": the server answers with the whole file although a part was requested",
                "serve the store from a server that supports byte ranges, as nginx, Apache and "
                "object stores do");
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
                    "open the address in a browser: it may need a login");
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
                    "the address of a store is that of the folder with its store.json");
    if (status == 401 || status == 403)
        return fail(Error::Code::Io,
                    said + ": access is denied, or not allowed with these credentials",
                    "set WAKESURF_HTTP_TOKEN, or WAKESURF_HTTP_S3_REGION and the keys of AWS; an "
                    "object store also answers so if the object does not exist");
    if (status >= 300 && status < 400)
        return fail(Error::Code::Io,
                    said + ", a redirect" +
                        (answer.location.empty() ? "" : ": " + printable(answer.location)),
                    "give the address it leads to: redirects are not followed");
    return fail(Error::Code::Io, said, comes_again(answer) ? "try again later" : "");
}

Result<std::uint64_t> size_told(const HttpRequest& request, const HttpAnswer& answer) {
    const std::string& address = request.address;
    if (answer.status == nothing_there) {
        if (answer.range && answer.range->total == 0)
            return 0;
        return fail(Error::Code::Io, address + ": the server cannot send its beginning");
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
                request.address + ": the server sends a different part than was requested");
}

tl::unexpected<Error> changed(const std::string& address) {
    return fail(Error::Code::Corrupt, address + " has changed since it was opened",
                "start again to use what is there now");
}

using core::Error;
using core::fail;
using core::FileIdentity;
using core::Result;

namespace {

constexpr std::chrono::milliseconds first_pause{100};
constexpr std::chrono::milliseconds longest_pause{5000};

// A store's description comes with the first request, in one answer: most of it is smaller. Together 4 MiB.
constexpr std::size_t beginning_bytes = std::size_t{256} << 10;
constexpr std::size_t most_beginnings = 16;

/// Says whether an object is an array of values, of which parts are read; all others are read as a whole.
bool holds_values(const std::string& address) {
    return address.ends_with(".f32") || address.ends_with(".f16");
}

/// Returns a pause that doubles each time, with jitter, so that connections do not retry at the same moment.
std::chrono::milliseconds
pause_before(int again, const HttpRequest& request, const HttpAnswer* answer) {
    const auto share =
        std::hash<std::uint64_t>()(request.range ? request.range->first >> 12 : 0) % 8;
    std::chrono::milliseconds time = first_pause * (1 << (again - 1));
    time += time * share / 8;
    if (answer != nullptr && answer->retry_after)
        time = std::max<std::chrono::milliseconds>(
            time, std::min<std::chrono::seconds>(*answer->retry_after, std::chrono::seconds(5)));
    return std::min(time, longest_pause);
}

} // namespace

WebDisk::WebDisk(std::shared_ptr<HttpTransport> transport, Pause pause, std::stop_token closing)
    : transport_(std::move(transport)), pause_(std::move(pause)), closing_(std::move(closing)) {}

void WebDisk::wait(std::chrono::milliseconds time, const std::stop_token& stop) {
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any never;
    never.wait_for(lock, stop, time, [] { return false; });
}

Result<HttpAnswer> WebDisk::ask(const HttpRequest& request,
                                std::span<std::byte> body,
                                const std::stop_token& unwanted) const {
    const core::EitherStop either(closing_, unwanted);
    const std::stop_token stop = either.token();
    for (int tries = 1;; ++tries) {
        auto answer = transport_->perform(request, body, stop);
        if (stop.stop_requested() || (!answer && answer.error().cancelled))
            return fail(Error::Code::Cancelled, "reading " + request.address + " was cancelled");
        const bool again = answer ? comes_again(*answer) : answer.error().passing;
        if (!again || tries == most_tries) {
            const std::string times = again ? ", " + std::to_string(tries) + " times" : "";
            if (!answer)
                return fail(Error::Code::Io, request.address + ": " + answer.error().what + times,
                            again ? "try again when the server can be reached" : "");
            return check_status(request, *answer, times).map([&] { return std::move(*answer); });
        }
        pause_(pause_before(tries, request, answer ? &*answer : nullptr), stop);
    }
}

Result<WebDisk::Known> WebDisk::look_at(const std::string& address,
                                        const std::stop_token& stop) const {
    HttpRequest request{address, holds_values(address), {}, {}};
    std::vector<std::byte> beginning;
    if (!request.head) {
        request.range = HttpRange{0, beginning_bytes};
        beginning.resize(beginning_bytes);
    }
    const auto answer = ask(request, beginning, stop);
    if (!answer)
        return tl::unexpected(answer.error());
    const auto size = size_told(request, *answer);
    if (!size)
        return tl::unexpected(size.error());
    if (!request.head) {
        beginning.resize(answer->bytes);
        keep(address, std::move(beginning));
    }
    return Known{*size, answer->etag, answer->last_modified};
}

Result<WebDisk::Known> WebDisk::known(const std::string& address,
                                      const std::stop_token& stop) const {
    std::shared_ptr<Object> object;
    {
        const std::scoped_lock lock(mutex_);
        auto& found = objects_[address];
        if (!found)
            found = std::make_shared<Object>();
        object = found;
    }
    const std::scoped_lock one_looks(object->mutex);
    if (!object->known) {
        auto looked = look_at(address, stop);
        if (!looked)
            return looked;
        object->known = std::move(*looked);
    }
    return *object->known;
}

void WebDisk::keep(const std::string& address, std::vector<std::byte> beginning) const {
    auto bytes = std::make_shared<const std::vector<std::byte>>(std::move(beginning));
    const std::scoped_lock lock(mutex_);
    beginnings_.emplace_front(address, std::move(bytes));
    if (beginnings_.size() > most_beginnings)
        beginnings_.pop_back();
}

WebDisk::Bytes WebDisk::beginning_of(const std::string& address) const {
    const std::scoped_lock lock(mutex_);
    const auto found = std::find_if(beginnings_.begin(), beginnings_.end(),
                                    [&](const auto& each) { return each.first == address; });
    if (found == beginnings_.end())
        return nullptr;
    beginnings_.splice(beginnings_.begin(), beginnings_, found);
    return found->second;
}

Result<std::uint64_t> WebDisk::size(const std::filesystem::path& file) const {
    return known(file.string(), {}).map([](const Known& it) { return it.size; });
}

Result<FileIdentity> WebDisk::identity(const std::filesystem::path& file) const {
    return known(file.string(), {}).map([](const Known& it) {
        const std::string& mark = it.etag.empty() ? it.modified : it.etag;
        return FileIdentity{it.size, std::hash<std::string>()(mark), 0};
    });
}

Result<void> WebDisk::read(const std::filesystem::path& file,
                           std::uint64_t offset,
                           std::span<std::byte> out) const {
    return read_stoppable(file, offset, out, {});
}

Result<void> WebDisk::read_stoppable(const std::filesystem::path& file,
                                     std::uint64_t offset,
                                     std::span<std::byte> out,
                                     const std::stop_token& stop) const {
    const core::BlockingWait blocked;
    const std::string address = file.string();
    const auto it = known(address, stop);
    if (!it)
        return tl::unexpected(it.error());
    if (offset > it->size || out.size() > it->size - offset)
        return fail(Error::Code::Corrupt, address + " ends before it should");
    if (const Bytes kept = beginning_of(address); kept && offset < kept->size()) {
        const auto from = static_cast<std::size_t>(offset);
        const std::size_t there = std::min(out.size(), kept->size() - from);
        std::memcpy(out.data(), kept->data() + from, there);
        out = out.subspan(there);
        offset += there;
    }
    for (; !out.empty(); out = out.subspan(std::min(most_bytes, out.size())), offset += most_bytes)
        if (auto part =
                read_part(address, *it, offset, out.first(std::min(most_bytes, out.size())), stop);
            !part)
            return part;
    return {};
}

Result<void> WebDisk::read_part(const std::string& address,
                                const Known& known,
                                std::uint64_t offset,
                                std::span<std::byte> out,
                                const std::stop_token& stop) const {
    HttpRequest request{address, false, HttpRange{offset, out.size()}, {}};
    if (known.etag.starts_with('"')) // a weak one never matches there
        request.if_match = known.etag;
    return ask(request, out, stop).and_then([&](const HttpAnswer& answer) -> Result<void> {
        const bool same =
            known.etag.empty() ? answer.last_modified == known.modified : answer.etag == known.etag;
        if (!same)
            return changed(address);
        return check_part(request, answer, known.size);
    });
}

} // namespace wakesurf::server
