#include "importer/sources/series/file_series.hpp"

#include "importer/sources/files/file_names.hpp"
#include "importer/sources/files/source_files.hpp"
#include "importer/sources/series/numbered_files.hpp"

namespace wakesurf::importer {

core::Result<FileSeries> open_file_series(const std::filesystem::path& source, bool alone) {
    const std::string extension = lower_extension(source);
    if (extension == ".pvd")
        return read_pvd_series(source);
    if (extension == ".series")
        return read_json_series(source);
    auto numbered = numbered_files(source, alone);
    if (!numbered)
        return tl::unexpected(numbered.error());
    FileSeries series{numbered->name, extension.empty() ? "file" : extension.substr(1), {}, {}};
    if (numbered->files.size() > 1)
        series.kind += " series";
    else
        series.name = numbered->files.front().stem().string();
    for (std::size_t i = 0; i < numbered->files.size(); ++i) {
        const auto& file = numbered->files[i];
        series.entries.push_back({{{file, file.filename().string(), {}}}, std::nullopt, {}});
        if (i < numbered->numbers.size())
            series.entries.back().number = numbered->numbers[i];
    }
    return series;
}

core::Result<std::vector<store::SourceFile>> fingerprint(const std::vector<ListedFile>& files) {
    std::vector<NamedFile> named;
    for (const auto& file : files)
        named.push_back({file.path, file.name});
    return fingerprint(named);
}

} // namespace wakesurf::importer
