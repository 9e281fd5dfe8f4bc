#include "store/import_progress.hpp"

#include "core/base/plain_text.hpp"
#include "protocol/api/base/json_members.hpp"
#include "protocol/api/base/json_text.hpp"

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace wakesurf::protocol {

using store::ImportProgress;

template <class Io>
void members(Io& io, Of<Io, ImportProgress>& of) {
    io.needed("phase", of.phase);
    io.needed("done", of.done);
    io.needed("total", of.total);
    io.some("file", of.file);
    io.some("note", of.note);
    io.some("remaining", of.remaining);
    io.some("velocities", of.velocities);
}

} // namespace wakesurf::protocol

namespace wakesurf::store {

using nlohmann::json;

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
    return protocol::json_text(protocol::written(progress));
}

std::optional<ImportProgress> parse_progress_line(std::string_view line) {
    const auto progress =
        protocol::parse_json(line, {}).and_then(protocol::parse_kept<ImportProgress>);
    return progress && progress->done <= progress->total ? std::optional(*progress) : std::nullopt;
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
