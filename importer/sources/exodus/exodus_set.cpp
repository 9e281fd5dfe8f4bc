#include "importer/sources/exodus/exodus_set.hpp"

#include "importer/base/notes.hpp"
#include "importer/sources/files/named_path.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <string_view>

namespace wakesurf::importer {

using core::Error;
namespace fs = std::filesystem;

namespace {

// Takes digits behind `mark` from the end of a name.
std::optional<unsigned> take_number(std::string& name, std::string_view mark) {
    const auto at = name.rfind(mark);
    if (at == std::string::npos || at == 0)
        return std::nullopt;
    unsigned number = 0;
    const char* const end = name.data() + name.size();
    const auto [stop, error] = std::from_chars(name.data() + at + mark.size(), end, number);
    if (error != std::errc() || stop != end || at + mark.size() == name.size())
        return std::nullopt;
    name.resize(at);
    return number;
}

using Pieces = std::map<unsigned, NamedFile>;

core::Result<std::vector<NamedFile>> whole(const Pieces& pieces, const ExodusName& of) {
    std::vector<NamedFile> out;
    for (unsigned i = 0; i < std::max(of.pieces, 1u); ++i) {
        const auto piece = pieces.find(i);
        if (piece == pieces.end()) {
            std::string missing = std::to_string(i);
            const std::string count = std::to_string(of.pieces);
            missing.insert(0, count.size() - std::min(count.size(), missing.size()), '0');
            return core::fail(Error::Code::NotFound,
                              pieces.begin()->second.name + " is one of " + count +
                                  " pieces, and " + of.base + of.of_restart + "." + count + "." +
                                  missing + " is not there",
                              "copy all pieces, or join them with epu");
        }
        out.push_back(piece->second);
    }
    return out;
}

} // namespace

ExodusName exodus_name(const std::string& name) {
    ExodusName out{name};
    if (auto base = name; const auto piece = take_number(base, "."))
        if (const auto pieces = take_number(base, "."); pieces && *piece < *pieces) {
            out.base = base;
            out.pieces = *pieces;
            out.piece = *piece;
        }
    if (auto base = out.base; const auto restart = take_number(base, "-s")) {
        out.of_restart = out.base.substr(base.size());
        out.base = base;
        out.restart = *restart;
    }
    return out;
}

core::Result<ExodusSet> find_exodus_set(const fs::path& path, bool alone) {
    const ExodusName wanted = exodus_name(path.filename().string());
    std::map<unsigned, std::pair<ExodusName, Pieces>> restarts;
    std::error_code error;
    const fs::path folder = path.parent_path();
    for (fs::directory_iterator at(folder.empty() ? fs::path(".") : folder, error), end;
         !error && at != end; at.increment(error)) {
        const std::string name = at->path().filename().string();
        const ExodusName here = exodus_name(name);
        if (here.base != wanted.base || here.pieces != wanted.pieces ||
            (alone && here.restart != wanted.restart))
            continue;
        if (name != path.filename().string())
            if (auto inside = named_path(folder, name, "the run of " + path.filename().string());
                !inside)
                return tl::unexpected(inside.error());
        auto& [of, pieces] = restarts[here.restart];
        of = here;
        pieces.insert_or_assign(here.piece, NamedFile{folder / name, name});
    }
    if (error)
        return core::fail(Error::Code::Io, "the folder of " + path.filename().string() +
                                               " cannot be listed: " + error.message());
    ExodusSet out{fs::path(wanted.base).stem().string(), {}, {}};
    unsigned before = 0;
    for (const auto& [number, restart] : restarts) {
        auto pieces = whole(restart.second, restart.first);
        if (!pieces)
            return tl::unexpected(pieces.error());
        if (before > 0 && number != before + 1)
            add_note(out.note, "no file of " + wanted.base + " between " +
                                   out.parts.back().front().name + " and " + pieces->front().name);
        before = number;
        out.parts.push_back(std::move(*pieces));
    }
    if (out.parts.empty())
        return core::fail(Error::Code::NotFound, path.filename().string() + " is not there");
    return out;
}

} // namespace wakesurf::importer
