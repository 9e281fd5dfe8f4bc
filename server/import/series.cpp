#include "server/import/series.hpp"

#include "core/base/disk.hpp"
#include "server/import/pvd_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace wakesurf::server {

using core::Error;
namespace fs = std::filesystem;

namespace {

std::string lower_extension(const fs::path& path) {
    std::string out = path.extension().string();
    std::transform(out.begin(), out.end(), out.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return out;
}

struct NumberedName {
    std::string prefix;
    std::uint64_t number = 0;
};

std::optional<NumberedName> numbered(const fs::path& path) {
    const std::string stem = path.stem().string();
    const auto last = stem.find_last_not_of("0123456789");
    const auto digits = last == std::string::npos ? 0 : last + 1;
    NumberedName out{stem.substr(0, digits), 0};
    const auto [end, error] =
        std::from_chars(stem.data() + digits, stem.data() + stem.size(), out.number);
    if (error != std::errc())
        return std::nullopt;
    return out;
}

// The given file alone, unless it is the first of a numbered series.
Series vti_series(const fs::path& first) {
    Series series{first.stem().string(), "vti", {}, {}};
    const auto name = numbered(first);
    std::vector<std::pair<std::uint64_t, fs::path>> found;
    std::error_code ignored;
    const fs::path folder = first.parent_path().empty() ? fs::path(".") : first.parent_path();
    if (name)
        for (const auto& entry : fs::directory_iterator(folder, ignored))
            if (const auto other = numbered(entry.path());
                other && other->prefix == name->prefix && lower_extension(entry.path()) == ".vti")
                found.emplace_back(other->number, entry.path());
    std::sort(found.begin(), found.end());
    if (found.size() < 2 || found.front().second.filename() != first.filename())
        found = {{0, first}};
    else
        series.reader = "vti series";
    if (const auto tidy = name ? name->prefix.find_last_not_of("_-. ") : std::string::npos;
        tidy != std::string::npos && found.size() > 1)
        series.name = name->prefix.substr(0, tidy + 1);
    for (const auto& [number, path] : found)
        series.files.push_back({path, path.filename().string(), std::nullopt});
    return series;
}

std::optional<double> number(std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

} // namespace

core::Result<TimeSelection> parse_times(const std::string& text) {
    std::vector<double> parts;
    bool sound = true;
    for (std::string_view rest = text; sound;) {
        const auto colon = rest.find(':');
        const auto part = number(rest.substr(0, colon));
        sound = part.has_value();
        parts.push_back(part.value_or(0.0));
        if (colon == std::string_view::npos)
            break;
        rest.remove_prefix(colon + 1);
    }
    if (parts.size() == 2)
        parts.push_back(1.0);
    if (!sound || parts.size() != 3 || parts[1] < parts[0] || parts[2] < 1 || parts[2] > 1e9 ||
        parts[2] != std::floor(parts[2]))
        return core::fail(Error::Code::InvalidArgument,
                          "--times " + text + " is not T0:T1 or T0:T1:EVERY",
                          "for example --times 8.5:16:2");
    return TimeSelection{parts[0], parts[1], static_cast<std::size_t>(parts[2])};
}

core::Result<Series> open_series(const fs::path& source) {
    const std::string name = source.filename().string();
    std::error_code error;
    if (fs::is_directory(source, error))
        return core::fail(Error::Code::Unsupported, name + " is a folder",
                          "give the .pvd or .vti file in it");
    const auto size = core::PosixDisk().size(source);
    if (!size)
        return tl::unexpected(size.error());
    if (*size == 0)
        return core::fail(Error::Code::Corrupt, name + " is empty");
    const std::string extension = lower_extension(source);
    if (extension == ".pvd")
        return read_pvd(source);
    if (extension == ".vti")
        return vti_series(source);
    return core::fail(Error::Code::Unsupported, name + " is of a format that cannot be read",
                      "formats: .pvd of .vti files, .vti, the first of numbered .vti files");
}

core::Result<std::vector<protocol::SourceFile>> fingerprint(const Series& series) {
    std::vector<protocol::SourceFile> out;
    const core::PosixDisk disk;
    const auto add = [&](const fs::path& path, const std::string& name) -> core::Result<void> {
        return disk.identity(path).map([&](const core::FileIdentity& found) {
            out.push_back({name, found.size, found.modified});
        });
    };
    for (const auto& path : series.index)
        if (auto added = add(path, path.filename().string()); !added)
            return tl::unexpected(added.error());
    for (const auto& file : series.files)
        if (auto added = add(file.path, file.name); !added) {
            if (!series.index.empty() && added.error().code == Error::Code::NotFound)
                return core::fail(Error::Code::NotFound, series.index.front().filename().string() +
                                                             " names " + file.name +
                                                             ", which is not there");
            return tl::unexpected(added.error());
        }
    return out;
}

} // namespace wakesurf::server
