#include "server/catalogue/import_progress.hpp"

#include "protocol/json_members.hpp"
#include "protocol/json_text.hpp"

#include <nlohmann/json.hpp>
#include <unistd.h>

namespace wakesurf::server {

std::string progress_line(const ImportProgress& progress) {
    nlohmann::json line{
        {"phase", progress.phase}, {"done", progress.done}, {"total", progress.total}};
    if (!progress.file.empty())
        line["file"] = progress.file;
    if (!progress.note.empty())
        line["note"] = progress.note;
    return protocol::json_text(line);
}

std::optional<ImportProgress> parse_progress_line(std::string_view line) {
    const auto value = protocol::parse_json(line, {});
    if (!value)
        return std::nullopt;
    protocol::JsonMembers members(*value);
    ImportProgress progress;
    progress.phase = members.text("phase");
    progress.done = members.count("done");
    progress.total = members.count("total");
    if (members.has("file"))
        progress.file = members.text("file");
    if (members.has("note"))
        progress.note = members.text("note");
    if (!members.verdict() || progress.done > progress.total)
        return std::nullopt;
    return progress;
}

void show_progress(const ImportProgress& progress, std::FILE* stream) {
    const bool terminal = ::isatty(::fileno(stream)) != 0;
    const char* const line_start = terminal ? "\r\033[K" : "";
    if (!progress.note.empty())
        std::fprintf(stream, "%simport: %s\n", line_start, progress.note.c_str());
    constexpr std::size_t width = 40;
    const std::size_t filled = progress.total == 0 ? 0 : width * progress.done / progress.total;
    if (terminal)
        std::fprintf(stream, "%simport [%s%s] %zu of %zu %s", line_start,
                     std::string(filled, '#').c_str(), std::string(width - filled, ' ').c_str(),
                     progress.done, progress.total, progress.file.c_str());
    if (terminal && progress.phase == "done")
        std::fputc('\n', stream);
    if (!terminal && progress.phase == "import")
        std::fprintf(stream, "import: %zu of %zu, %s\n", progress.done, progress.total,
                     progress.file.c_str());
    std::fflush(stream);
}

} // namespace wakesurf::server
