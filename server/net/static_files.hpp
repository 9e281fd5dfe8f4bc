// The built web client, read into memory at the start: a request only ever looks a path up in a map, so there is no
// path to traverse.
#pragma once

#include "server/net/http_message.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace wakesurf::server {

class StaticFiles {
  public:
    /// Every regular file below `folder`; none when it is not there.
    static StaticFiles load(const std::filesystem::path& folder);

    bool empty() const { return files_.empty(); }

    bool has(std::string_view path) const { return path == "/" || files_.contains(path); }

    /// GET or HEAD of a path that has() said yes to. `/` is index.html.
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

/// MIME type by the file's extension.
std::string_view mime_type(std::string_view path);

/// Where the client was built to or installed, seen from the executable; empty when in neither place.
std::filesystem::path find_web_client();

} // namespace wakesurf::server
