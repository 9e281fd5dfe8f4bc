#include "importer/sources/series/json_series.hpp"

#include "importer/sources/files/file_names.hpp"
#include "importer/sources/files/named_path.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>

namespace wakesurf::importer {

using core::Error;
using nlohmann::json;

namespace {

core::Result<SeriesEntry>
read_entry(const json& element, const std::filesystem::path& folder, const std::string& series) {
    const auto name = element.is_object() ? element.find("name") : element.end();
    if (name == element.end() || !name->is_string() || name->get<std::string>().empty())
        return core::fail(Error::Code::Corrupt, series + " has an entry without a name");
    const auto file = name->get<std::string>();
    const auto path = named_path(folder, file, series);
    if (!path)
        return tl::unexpected(path.error());
    SeriesEntry entry{{{*path, told_name(file), {}}}, std::nullopt, {}};
    if (const auto time = element.find("time"); time != element.end()) {
        if (!time->is_number() || !std::isfinite(time->get<double>()))
            return core::fail(Error::Code::Corrupt, series + " gives " + file + " the time '" +
                                                        time->dump() +
                                                        "', which is not a finite number");
        entry.time = time->get<double>();
    }
    return entry;
}

} // namespace

core::Result<FileSeries> read_json_series(const std::filesystem::path& file) {
    const std::string name = file.filename().string();
    std::ifstream in(file, std::ios::binary);
    if (!in)
        return core::fail(Error::Code::Io, "cannot open " + name);
    const json root = json::parse(in, nullptr, false);
    const auto files = root.is_object() ? root.find("files") : root.end();
    if (!root.is_object() || files == root.end() || !files->is_array())
        return core::fail(Error::Code::Corrupt,
                          name + " is not a file series: it is not JSON with a list of files");
    // flow.vtm.series is about flow, made of .vtm files.
    const auto stem = file.stem();
    const auto kind = lower_extension(stem);
    FileSeries series{
        stem.stem().string(), kind.empty() ? "series" : kind.substr(1) + ".series", {file}, {}};
    for (const auto& element : *files) {
        auto entry = read_entry(element, file.parent_path(), name);
        if (!entry)
            return tl::unexpected(entry.error());
        series.entries.push_back(std::move(*entry));
    }
    if (series.entries.empty())
        return core::fail(Error::Code::Corrupt, name + " names no files");
    return series;
}

} // namespace wakesurf::importer
