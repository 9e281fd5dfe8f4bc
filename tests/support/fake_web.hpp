// A web server that is a folder: requests are recorded, and a test can answer in its place.
#pragma once

#include "server/remote/web/http_transport.hpp"
#include "tests/support/temporary_folder.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::tests {

class FakeWeb final : public server::HttpTransport {
  public:
    using Answer = tl::expected<server::HttpAnswer, server::HttpFault>;

    /// Answers instead of the folder; empty: the folder answers.
    using Instead =
        std::function<std::optional<Answer>(const server::HttpRequest&, std::span<std::byte>)>;

    static constexpr std::string_view address = "https://example.org/data";

    explicit FakeWeb(std::filesystem::path folder) : folder_(std::move(folder)) {}

    Answer perform(const server::HttpRequest& request,
                   std::span<std::byte> body,
                   const std::stop_token&) override {
        Instead now;
        {
            const std::scoped_lock lock(mutex_);
            asked_.push_back(request);
            now = instead_;
        }
        if (now)
            if (auto answer = now(request, body))
                return std::move(*answer);
        return answer(request, body);
    }

    /// Returns the folder's answer.
    Answer answer(const server::HttpRequest& request, std::span<std::byte> body) const {
        server::HttpAnswer out;
        const auto file = folder_ / request.address.substr(address.size() + 1);
        if (!std::filesystem::exists(file)) {
            out.status = 404;
            return out;
        }
        const std::string all = read_file(file);
        out.content_type = "application/octet-stream";
        out.etag = '"' + std::to_string(std::hash<std::string>()(all)) + '"';
        out.status = 412;
        if (!request.if_match.empty() && request.if_match != out.etag)
            return out;
        const std::uint64_t first = request.range ? request.range->first : 0;
        const std::uint64_t end =
            request.range ? std::min<std::uint64_t>(first + request.range->count, all.size())
                          : all.size();
        out.status = 416;
        out.range = server::HttpAnswer::Range{std::nullopt, std::nullopt, all.size()};
        if (request.range && first >= end)
            return out;
        out.status = request.range ? 206 : 200;
        out.range->first = first;
        out.range->last = end - 1;
        out.content_length = end - first;
        out.bytes = request.head ? 0 : std::min<std::size_t>(body.size(), end - first);
        out.longer = !request.head && body.size() < end - first;
        if (out.bytes > 0)
            std::memcpy(body.data(), all.data() + first, out.bytes);
        return out;
    }

    void instead(Instead answer) {
        const std::scoped_lock lock(mutex_);
        instead_ = std::move(answer);
    }

    /// Returns the requests: "HEAD NAME", "NAME", "NAME FIRST+COUNT".
    std::vector<std::string> asked() const {
        const std::scoped_lock lock(mutex_);
        std::vector<std::string> out;
        for (const auto& each : asked_)
            out.push_back((each.head ? "HEAD " : "") + each.address.substr(address.size() + 1) +
                          (each.range ? " " + std::to_string(each.range->first) + "+" +
                                            std::to_string(each.range->count)
                                      : ""));
        return out;
    }

  private:
    std::filesystem::path folder_;
    mutable std::mutex mutex_; ///< guards what follows
    std::vector<server::HttpRequest> asked_;
    Instead instead_;
};

} // namespace wakesurf::tests
