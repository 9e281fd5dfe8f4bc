#include "server/data/dataset_argument.hpp"

#include "core/base/plain_text.hpp"
#include "server/remote/remote_dataset.hpp"
#include "store/store_manifest.hpp"

#include <cstdint>
#include <cstdlib>

namespace wakesurf::server {

using core::Error;
namespace fs = std::filesystem;

namespace {

constexpr std::string_view flow_prefix = "flow:";
constexpr std::size_t longest_file_name = 255; // of a file

// Recognizes flow_*.vtu and flow_%04d.vtu: the importer finds the files.
bool is_pattern(const std::string& name) {
    return name.find_first_of("*%") != std::string::npos;
}

DatasetArgument resolve_path(const fs::path& path) {
    DatasetArgument out;
    out.path = path;
    if (fs::is_directory(path) && (fs::exists(path / store::manifest_file_name) || is_zarr(path))) {
        out.kind = DatasetArgument::Kind::Store;
        out.name = path.filename().string();
    } else if (path.filename() == store::manifest_file_name) {
        return resolve_path(path.parent_path());
    } else if (fs::is_directory(path)) {
        out.name = path.filename().string();
    } else {
        out.name = path.stem().string();
    }
    out.name = core::display_name(out.name, longest_file_name);
    return out;
}

} // namespace

core::Result<DatasetArgument> resolve_dataset(const std::string& argument) {
    if (argument.empty())
        return core::fail(Error::Code::InvalidArgument, "the name of the dataset is empty",
                          "give a file, a folder, the address of a store, or flow:NAME");
    if (argument.starts_with(flow_prefix)) {
        DatasetArgument out;
        out.kind = DatasetArgument::Kind::Flow;
        out.flow = argument.substr(flow_prefix.size());
        out.name = out.flow;
        return out;
    }
    if (is_web_address(argument))
        return store_address(argument).map([](const std::string& address) {
            DatasetArgument out;
            out.kind = DatasetArgument::Kind::Store;
            out.path = address;
            out.name = core::display_name(out.path.filename().string(), longest_file_name);
            return out;
        });
    try {
        const fs::path path(argument);
        const bool there = fs::exists(path);
        if (fs::is_directory(path) || (!there && !is_pattern(path.filename().string())))
            return resolve_path(fs::canonical(path));
        // A link to a file keeps its name: the files of its series are those beside it.
        return resolve_path(fs::canonical(path.has_parent_path() ? path.parent_path() : ".") /
                            path.filename());
    } catch (const fs::filesystem_error& error) {
        const auto code = error.code() == std::errc::no_such_file_or_directory
                              ? Error::Code::NotFound
                              : Error::Code::Io;
        return core::fail(code, "cannot read " + fs::path(argument).filename().string() + ": " +
                                    error.code().message());
    }
}

core::Result<void> check_source_options(const DatasetArgument& argument,
                                        const command::SourceOptions& options) {
    if (argument.kind == DatasetArgument::Kind::Source)
        return {};
    const std::string what =
        argument.name +
        (argument.kind == DatasetArgument::Kind::Flow ? " is a built-in flow" : " is a store");
    if (options.times())
        return core::fail(Error::Code::InvalidArgument,
                          std::string(options.dt ? "--dt" : "--start") +
                              " is for numbered files that state no times; " + what,
                          "leave it out, or import the files with it");
    if (options.loop || !options.mask.empty())
        return core::fail(Error::Code::InvalidArgument,
                          (options.loop ? "--loop is for the times of files; "
                                        : "--mask is for the fields of files; ") +
                              what,
                          "leave it out, or import the files with it");
    if (core::any(options.periodic))
        return core::fail(Error::Code::InvalidArgument,
                          "--periodic says along which axes the flow of files repeats; " + what,
                          "leave it out, or import the files with it");
    if (!options.velocity.empty())
        return core::fail(Error::Code::InvalidArgument,
                          "--velocity chooses among the fields of files; " + what +
                              ", which has one velocity",
                          "leave it out, or import the files with it");
    return {};
}

fs::path default_store_root() {
    const auto folder = [](const char* variable) {
        const char* value = std::getenv(variable);
        return value == nullptr ? fs::path() : fs::path(value);
    };
    if (auto named = folder("WAKESURF_STORE"); !named.empty())
        return named;
    if (const auto cache = folder("XDG_CACHE_HOME"); cache.is_absolute())
        return cache / "wakesurf";
    if (const auto home = folder("HOME"); home.is_absolute())
        return home / ".cache" / "wakesurf";
    return fs::current_path() / "wakesurf-cache";
}

fs::path store_folder(const fs::path& root,
                      const DatasetArgument& source,
                      const command::SourceOptions& options) {
    std::uint64_t hash = 0xcbf29ce484222325u; // FNV-1a
    std::string chosen;
    for (const std::string& option : arguments_of(options))
        if (!option.starts_with("--dt") && !option.starts_with("--start") && option != "--confined")
            chosen += "\n" + option;
    for (const char c : source.path.string() + chosen)
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
