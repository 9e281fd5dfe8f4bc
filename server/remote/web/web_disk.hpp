// A store's files on a web server or an object store, as a disk for the store reader: each read is a range of
// an object. Answers are checked here; the bytes themselves are checked above, by their checksums.
#pragma once

#include "core/base/disk.hpp"
#include "server/remote/web/http_transport.hpp"

#include <chrono>
#include <cstddef>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::server {

/// Reads objects. Size and mark (ETag, else the modification time) of an object are those of its first
/// request. If another object replaces it, reading reports that. Errors name its address. Thread safety:
/// concurrent calls are allowed.
class WebDisk final : public core::Disk {
  public:
    /// Waits that long, or until `stop` fires.
    using Pause = std::function<void(std::chrono::milliseconds, const std::stop_token& stop)>;

    /// The number of tries of a request without an answer, or with one that asks to retry.
    static constexpr int most_tries = 5;

    /// The largest part requested at once.
    static constexpr std::size_t most_bytes = std::size_t{16} << 20;

    /// @param closing  ends all questions, whoever asked
    explicit WebDisk(std::shared_ptr<HttpTransport> transport,
                     Pause pause = wait,
                     std::stop_token closing = {});

    core::Result<std::uint64_t> size(const std::filesystem::path& file) const override;
    core::Result<core::FileIdentity> identity(const std::filesystem::path& file) const override;
    core::Result<void> read(const std::filesystem::path& file,
                            std::uint64_t offset,
                            std::span<std::byte> out) const override;
    core::Result<void> read_stoppable(const std::filesystem::path& file,
                                      std::uint64_t offset,
                                      std::span<std::byte> out,
                                      const std::stop_token& stop) const override;

    /// Returns one reader a connection.
    Pace pace() const override { return {64, most_bytes}; }

    static void wait(std::chrono::milliseconds time, const std::stop_token& stop);

  private:
    struct Known {
        std::uint64_t size = 0;
        std::string etag;     ///< or empty
        std::string modified; ///< where there is no ETag
    };

    struct Object {
        std::mutex mutex; ///< held during the first request: one thread makes it for all
        std::optional<Known> known;
    };

    using Bytes = std::shared_ptr<const std::vector<std::byte>>;

    core::Result<Known> known(const std::string& address, const std::stop_token& stop) const;
    core::Result<Known> look_at(const std::string& address, const std::stop_token& stop) const;
    core::Result<void> read_part(const std::string& address,
                                 const Known& known,
                                 std::uint64_t offset,
                                 std::span<std::byte> out,
                                 const std::stop_token& stop) const;
    core::Result<HttpAnswer>
    ask(const HttpRequest& request, std::span<std::byte> body, const std::stop_token& stop) const;
    void keep(const std::string& address, std::vector<std::byte> beginning) const;
    Bytes beginning_of(const std::string& address) const;

    std::shared_ptr<HttpTransport> transport_;
    Pause pause_;
    std::stop_token closing_;
    mutable std::mutex mutex_; ///< guards what follows
    mutable std::map<std::string, std::shared_ptr<Object>> objects_;
    mutable std::list<std::pair<std::string, Bytes>> beginnings_; ///< of small files, newest first
};

} // namespace wakesurf::server
