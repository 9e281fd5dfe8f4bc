// The built web client, read into memory at the start: requests are looked up in a map, so there is no path
// to traverse.
#pragma once

#include "core/base/result.hpp"
#include "server/net/http_message.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::server {

class StaticFiles {
  public:
    /// Loads every regular file below `folder`; none if it does not exist.
    static StaticFiles load(const std::filesystem::path& folder);

    bool empty() const { return files_.empty(); }

    bool has(std::string_view path) const { return path == "/" || files_.contains(path); }

    /// Returns the bytes of a file; null if there is none.
    std::shared_ptr<const std::string> bytes(std::string_view path) const;

    /// Answers GET or HEAD of a path for which has() is true. `/` is index.html.
    HttpResponse respond(const HttpRequest& request) const;

  private:
    struct File {
        std::shared_ptr<const std::string> bytes;
        std::string type;
        std::string etag;
        bool hashed = false; ///< its name changes with its content
    };

    std::map<std::string, File, std::less<>> files_;
};

/// Returns the MIME type of the file's extension.
std::string_view mime_type(std::string_view path);

/// Returns the folder of the client, built or installed, relative to the executable; empty if there is none.
std::filesystem::path find_web_client();

/// The viewer of animations, one of the client's files.
inline constexpr std::string_view viewer_path = "/animation.html";

/// Reads it from the folder of the client. Error: NotFound.
core::Result<std::string> read_animation_viewer();

/// Returns the error where there is none.
core::Error no_animation_viewer();

} // namespace wakesurf::server
