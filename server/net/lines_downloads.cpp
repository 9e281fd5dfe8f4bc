#include "server/net/lines_downloads.hpp"

#include "protocol/api/generated/names.hpp"
#include "protocol/wire/lines_file.hpp"
#include "server/base/limits.hpp"
#include "server/base/split.hpp"
#include "server/data/dataset_lines.hpp"
#include "server/data/line_seeds_text.hpp"
#include "server/net/download_request.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <chrono>
#include <memory>
#include <stop_token>
#include <utility>

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

/// So many lines both ways are a quick job, of some 10 ms.
constexpr std::size_t quick_lines = 50;
/// How long lines wait for memory that others give back.
constexpr std::chrono::seconds patience{1};

core::Result<std::uint32_t> read_line_seeds(const std::string& text) {
    std::uint32_t seeds = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, seeds);
    if (read.ec != std::errc{} || read.ptr != end || seeds < 1 || seeds > limits::line_seeds)
        return fail(Error::Code::InvalidArgument,
                    fmt::format("`seeds` is not a whole number from 1 to {}", limits::line_seeds),
                    "?seeds=50 releases 50 lines");
    return seeds;
}

core::Result<core::Direction> read_direction(const std::string& text) {
    for (const auto& [direction, word] : protocol::words_of<core::Direction>)
        if (text == word)
            return direction;
    return fail(Error::Code::InvalidArgument, "`direction` is not forward, backward or both",
                "as in ?direction=both");
}

/// Reads a limit of lines, of which 0 is none.
core::Result<double> read_end(const std::string& name, const std::string& text) {
    const auto number = finite_number(text);
    return number && *number >= 0.0
               ? core::Result<double>(*number)
               : fail(Error::Code::InvalidArgument, "`" + name + "` is not a number from 0",
                      "as in ?" + name + "=2.5; 0 is none");
}

/// Holds the input of a file.
struct LinesWork {
    core::LineSeeds seeds;
    core::StreamLinesRequest request;
    std::shared_ptr<const LoadedDataset> dataset; ///< keeps what the field needs
    const core::MemoryAccount* account;

    core::Result<std::string> make(const std::stop_token& stop,
                                   core::MemoryAccount::Share& share) const {
        core::WorkMemory memory(*account, stop, patience, "these lines");
        const auto lines = dataset_lines(seeds, request, *dataset, memory, stop);
        if (!lines)
            return tl::unexpected(lines.error());
        const std::size_t bytes = protocol::lines_file_bytes(lines->lines(), lines->points.size());
        if (!share.grow_to(2 * bytes))
            return tl::unexpected(account->refusal("the file of these lines", 2 * bytes));
        return protocol::lines_file(*lines, request.time);
    }

    PriorityClass priority() const {
        return !core::of_walls(seeds.kind) && seeds.seeds <= quick_lines ? PriorityClass::Quick
                                                                         : PriorityClass::Long;
    }
};

} // namespace

core::Result<LinesQuery> read_lines_query(const std::map<std::string, std::string>& query) {
    LinesQuery out;
    const auto take = [](auto& into) { return [&into](const auto& value) { into = value; }; };
    std::uint32_t seeds = core::LineSeeds{}.seeds;
    std::vector<std::string> patches;
    for (const auto& [name, value] : query) {
        core::Result<void> read;
        if (name == "from")
            read = parse_line_seeds(value, "`from`").map(take(out.seeds));
        else if (name == "patch")
            patches = lines_of(value);
        else if (name == "seeds")
            read = read_line_seeds(value).map(take(seeds));
        else if (name == "direction")
            read = read_direction(value).map(take(out.direction));
        else if (name == "duration")
            read = read_end(name, value).map(take(out.duration));
        else if (name == "length")
            read = read_end(name, value).map(take(out.length));
        else if (name == "time")
            read = read_field_time(value).map(take(out.time));
        else if (name == "field")
            out.field = value;
        else
            read = fail(Error::Code::InvalidArgument,
                        "lines have no parameter `" + name.substr(0, 64) + "`",
                        "the parameters are ?from=line:0,0,0:1,0,0, ?patch=NAME, ?seeds=50, "
                        "?direction=both, "
                        "?duration=2, ?length=10, ?field=p and ?time=2.5");
        if (!read)
            return tl::unexpected(read.error());
    }
    if (!query.contains("from"))
        return fail(Error::Code::InvalidArgument, "`from` is missing",
                    "write ?from=line:0,0,0:1,0,0, plane:..., sphere:..., walls:... or along");
    out.seeds.seeds = seeds;
    out.seeds.patches = patches;
    return out;
}

core::Result<FieldFile> plan_lines(const std::map<std::string, std::string>& query,
                                   const FieldSource& source) {
    const auto wanted = read_lines_query(query);
    if (!wanted)
        return tl::unexpected(wanted.error());
    const auto values = field_at(wanted->field, wanted->time, source);
    if (!values)
        return tl::unexpected(values.error());
    const LinesWork work{wanted->seeds,
                         {wanted->direction, values->field, values->time, wanted->duration,
                          wanted->length, limits::line_points},
                         values->dataset,
                         &source.account};
    return FieldFile{
        fmt::format("lines {} {} {} {} {} {} {}", values->tag, line_seeds_text(wanted->seeds),
                    fmt::join(wanted->seeds.patches, "\n"), wanted->seeds.seeds,
                    static_cast<int>(wanted->direction), wanted->duration, wanted->length),
        work.priority(), [work](const std::stop_token& stop, core::MemoryAccount::Share& share) {
            return work.make(stop, share);
        }};
}

} // namespace wakesurf::server
