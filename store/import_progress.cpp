#include "store/import_progress.hpp"

#include "core/base/plain_text.hpp"
#include "protocol/api/base/json_members.hpp"
#include "protocol/api/base/json_text.hpp"

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace wakesurf::store {

namespace {

std::string time_left(const ImportProgress& progress) {
    if (!progress.remaining || progress.done == progress.total)
        return {};
    const auto seconds = static_cast<long>(std::ceil(*progress.remaining));
    return seconds < 120 ? ", " + std::to_string(seconds) + " s left"
                         : ", " + std::to_string(seconds / 60) + " min left";
}

} // namespace

std::string progress_line(const ImportProgress& progress) {
    nlohmann::json line{
        {"phase", progress.phase}, {"done", progress.done}, {"total", progress.total}};
    if (!progress.file.empty())
        line["file"] = progress.file;
    if (!progress.note.empty())
        line["note"] = progress.note;
    if (progress.remaining)
        line["remaining"] = *progress.remaining;
    if (!progress.velocities.empty())
        line["velocities"] = progress.velocities;
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
    if (members.has("remaining"))
        progress.remaining = members.number("remaining");
    if (members.has("velocities"))
        for (const auto& each : members.list("velocities"))
            if (each.is_string())
                progress.velocities.push_back(each.get<std::string>());
    if (!members.verdict() || progress.done > progress.total)
        return std::nullopt;
    return progress;
}

void show_progress(const ImportProgress& progress, std::FILE* stream, std::string_view work) {
    if (!progress.velocities.empty())
        return; // the error that follows names them
    const bool terminal = ::isatty(::fileno(stream)) != 0;
    const std::string line_start = std::string(terminal ? "\r\033[K" : "") + std::string(work);
    if (!progress.note.empty())
        std::fprintf(stream, "%s: %s\n", line_start.c_str(),
                     core::printable_line(progress.note).c_str());
    const std::string file = core::printable_line(progress.file);
    constexpr std::size_t width = 40;
    const double done = static_cast<double>(progress.done) + progress.part;
    const auto filled =
        progress.total == 0
            ? std::size_t{0}
            : std::min(width, static_cast<std::size_t>(width * done /
                                                       static_cast<double>(progress.total)));
    if (terminal)
        std::fprintf(stream, "%s [%s%s] %zu of %zu %s%s", line_start.c_str(),
                     std::string(filled, '#').c_str(), std::string(width - filled, ' ').c_str(),
                     progress.done, progress.total, file.c_str(), time_left(progress).c_str());
    if (terminal && progress.phase == "done")
        std::fputc('\n', stream);
    if (!terminal && progress.phase == work)
        std::fprintf(stream, "%s: %zu of %zu, %s\n", line_start.c_str(), progress.done,
                     progress.total, file.c_str());
    std::fflush(stream);
}

} // namespace wakesurf::store
