#include "server/net/static_files.hpp"

#include "core/base/crc32c.hpp"
#include "server/base/shipped_files.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <iterator>

namespace wakesurf::server {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::pair<std::string_view, std::string_view>, 14> types{{
    {".html", "text/html; charset=utf-8"},
    {".js", "text/javascript; charset=utf-8"},
    {".mjs", "text/javascript; charset=utf-8"},
    {".css", "text/css; charset=utf-8"},
    {".wasm", "application/wasm"},
    {".json", "application/json"},
    {".map", "application/json"},
    {".svg", "image/svg+xml"},
    {".png", "image/png"},
    {".ico", "image/x-icon"},
    {".woff2", "font/woff2"},
    {".txt", "text/plain; charset=utf-8"},
    {".py", "text/x-python; charset=utf-8"},
    {".webmanifest", "application/manifest+json"},
}};

std::string read(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace

std::string_view mime_type(std::string_view path) {
    for (const auto& [extension, type] : types)
        if (path.ends_with(extension))
            return type;
    return "application/octet-stream";
}

StaticFiles StaticFiles::load(const fs::path& folder) {
    StaticFiles out;
    std::error_code error;
    for (fs::recursive_directory_iterator each(folder, error), end; !error && each != end;
         each.increment(error)) {
        if (!each->is_regular_file(error))
            continue;
        const std::string path = "/" + fs::relative(each->path(), folder, error).generic_string();
        File file;
        file.bytes = std::make_shared<const std::string>(read(each->path()));
        file.type = mime_type(path);
        file.etag =
            fmt::format("\"{:08x}-{:x}\"", core::crc32c(std::as_bytes(std::span(*file.bytes))),
                        file.bytes->size());
        file.hashed = path.starts_with("/assets/");
        out.files_.emplace(path, std::move(file));
    }
    return out;
}

std::shared_ptr<const std::string> StaticFiles::bytes(std::string_view path) const {
    const auto found = files_.find(path);
    return found == files_.end() ? nullptr : found->second.bytes;
}

HttpResponse StaticFiles::respond(const HttpRequest& request) const {
    const auto found = files_.find(request.path == "/" ? std::string_view("/index.html")
                                                       : std::string_view(request.path));
    if (found == files_.end())
        return http_text(
            503, "The web client is not built: run `./run`, or start wakesurf with --web DIR.\n");
    const File& file = found->second;
    HttpResponse response{
        request.has(file.etag) ? 304U : 200U,
        {{"ETag", file.etag},
         {"Cache-Control", file.hashed ? "public, max-age=31536000, immutable" : "no-cache"}}};
    if (response.status == 200) {
        response.headers.emplace_back("Content-Type", file.type);
        response.body = file.bytes;
    }
    return response;
}

fs::path find_web_client() {
    std::error_code error;
    const fs::path here = this_program().parent_path();
    for (const char* place : {"../share/wakesurf/web", "../../../web-client/dist"})
        if (const fs::path folder = (here / place).lexically_normal();
            fs::exists(folder / "index.html", error))
            return folder;
    return {};
}

core::Error no_animation_viewer() {
    return {core::Error::Code::NotFound,
            "the viewer of animations was not found beside this program",
            "install all of wakesurf, or build the web client: ./run"};
}

core::Result<std::string> read_animation_viewer() {
    const auto folder = find_web_client();
    std::ifstream stream(folder / viewer_path.substr(1), std::ios::binary);
    if (folder.empty() || !stream)
        return tl::unexpected(no_animation_viewer());
    return std::string(std::istreambuf_iterator<char>(stream), {});
}

} // namespace wakesurf::server
