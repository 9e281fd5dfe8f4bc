#include "server/catalogue/dataset_argument.hpp"

#include "protocol/store_manifest.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <set>

namespace wakesurf::server {

using core::Error;
namespace fs = std::filesystem;

namespace {

constexpr std::string_view flow_prefix = "flow:";

bool has_extension(const fs::path& path, std::string_view extension) {
    std::string own = path.extension().string();
    std::transform(own.begin(), own.end(), own.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return own == extension;
}

// Files that differ only in the digits before the extension are one series.
std::string series_key(const fs::path& path) {
    std::string stem = path.stem().string();
    const auto last = stem.find_last_not_of("0123456789");
    stem.erase(last == std::string::npos ? 0 : last + 1);
    return stem;
}

std::uint64_t series_number(const fs::path& path) {
    const std::string digits = path.stem().string().substr(series_key(path).size());
    return digits.empty() ? 0 : std::strtoull(digits.c_str(), nullptr, 10);
}

core::Result<fs::path> only_thing_in(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> pvd;
    std::vector<fs::path> vti;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        if (has_extension(entry.path(), ".pvd"))
            pvd.push_back(entry.path());
        if (has_extension(entry.path(), ".vti"))
            vti.push_back(entry.path());
    }
    const std::string name = folder.filename().string();
    if (error)
        return core::fail(Error::Code::Io,
                          "cannot list the folder " + name + ": " + error.message());
    std::set<std::string> series;
    std::transform(vti.begin(), vti.end(), std::inserter(series, series.end()), series_key);
    if (pvd.empty() && series.size() == 1)
        return *std::min_element(vti.begin(), vti.end(), [](const fs::path& a, const fs::path& b) {
            return series_number(a) < series_number(b);
        });
    if (pvd.size() == 1)
        return pvd.front();
    if (pvd.empty() && vti.empty())
        return core::fail(Error::Code::InvalidArgument,
                          "the folder " + name + " holds nothing that can be imported",
                          "formats: .pvd of .vti files, .vti");
    std::set<std::string> names;
    for (const auto& path : pvd.empty() ? vti : pvd)
        names.insert(path.filename().string());
    std::string all;
    for (const auto& one : names)
        all += (all.empty() ? "" : ", ") + one;
    constexpr std::size_t longest = 300;
    return core::fail(Error::Code::InvalidArgument,
                      "the folder " + name + " holds several datasets: " + all.substr(0, longest),
                      "name one of them");
}

core::Result<DatasetArgument> resolve_path(const fs::path& path) {
    DatasetArgument out;
    out.path = path;
    if (fs::is_directory(path) && fs::exists(path / protocol::manifest_file_name)) {
        out.kind = DatasetArgument::Kind::Store;
        out.name = path.filename().string();
    } else if (path.filename() == protocol::manifest_file_name) {
        return resolve_path(path.parent_path());
    } else if (fs::is_directory(path)) {
        auto only = only_thing_in(path);
        if (!only)
            return tl::unexpected(only.error());
        return resolve_path(*only);
    } else {
        out.name = path.stem().string();
    }
    return out;
}

} // namespace

core::Result<DatasetArgument> resolve_dataset(const std::string& argument) {
    if (argument.starts_with(flow_prefix)) {
        DatasetArgument out;
        out.kind = DatasetArgument::Kind::Flow;
        out.flow = argument.substr(flow_prefix.size());
        out.name = out.flow;
        return out;
    }
    try {
        return resolve_path(fs::canonical(argument));
    } catch (const fs::filesystem_error& error) {
        const auto code = error.code() == std::errc::no_such_file_or_directory
                              ? Error::Code::NotFound
                              : Error::Code::Io;
        return core::fail(code, "cannot read " + fs::path(argument).filename().string() + ": " +
                                    error.code().message());
    }
}

fs::path default_store_root() {
    const auto folder = [](const char* variable) {
        const char* value = std::getenv(variable);
        return value == nullptr ? fs::path() : fs::path(value);
    };
    if (const auto cache = folder("XDG_CACHE_HOME"); cache.is_absolute())
        return cache / "wakesurf";
    if (const auto home = folder("HOME"); home.is_absolute())
        return home / ".cache" / "wakesurf";
    return fs::current_path() / "wakesurf-cache";
}

fs::path store_folder(const fs::path& root, const DatasetArgument& source) {
    std::uint64_t hash = 0xcbf29ce484222325u; // FNV-1a
    for (const char c : source.path.string())
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    std::string digits;
    for (int shift = 60; shift >= 0; shift -= 4)
        digits += "0123456789abcdef"[(hash >> shift) & 0xf];
    return root / (slug(source.name) + "-" + digits);
}

std::string slug(std::string_view name) {
    constexpr std::size_t longest = 64;
    std::string out;
    for (const char c : name.substr(0, longest)) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                           (c >= '0' && c <= '9') || c == '_' || (c == '.' && !out.empty());
        if (plain)
            out += c;
        else if (!out.empty() && out.back() != '-')
            out += '-';
    }
    while (!out.empty() && out.back() == '-')
        out.pop_back();
    return out.empty() ? "dataset" : out;
}

} // namespace wakesurf::server
