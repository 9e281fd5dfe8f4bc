#include "server/import/pvd_file.hpp"

#include "server/import/vtk_messages.hpp"

#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <set>

namespace wakesurf::server {

using core::Error;

namespace {

core::Result<SeriesFile> read_entry(vtkXMLDataElement& element,
                                    const std::filesystem::path& folder,
                                    const std::string& pvd) {
    const char* file = element.GetAttribute("file");
    if (file == nullptr || *file == '\0')
        return core::fail(Error::Code::Corrupt, pvd + " has a DataSet without a file");
    SeriesFile entry{folder / file, file, std::nullopt};
    if (const char* time = element.GetAttribute("timestep"); time != nullptr) {
        double value = 0.0;
        const char* const end = time + std::strlen(time);
        const auto [stop, error] = std::from_chars(time, end, value);
        if (error != std::errc() || stop != end || !std::isfinite(value))
            return core::fail(Error::Code::Corrupt, pvd + " gives " + entry.name + " the time '" +
                                                        time + "', which is no finite number");
        entry.time = value;
    }
    return entry;
}

core::Result<void> sort_by_time(Series& series, const std::string& pvd) {
    auto& files = series.files;
    const auto timed = std::count_if(files.begin(), files.end(),
                                     [](const SeriesFile& f) { return f.time.has_value(); });
    if (timed == 0)
        return {};
    if (static_cast<std::size_t>(timed) != files.size())
        return core::fail(Error::Code::Corrupt, pvd + " gives only some of its files a time");
    std::stable_sort(files.begin(), files.end(),
                     [](const SeriesFile& a, const SeriesFile& b) { return *a.time < *b.time; });
    const auto twice = std::adjacent_find(
        files.begin(), files.end(),
        [](const SeriesFile& a, const SeriesFile& b) { return *a.time == *b.time; });
    if (twice != files.end())
        return core::fail(Error::Code::Unsupported,
                          pvd + " gives " + twice->name + " and " + std::next(twice)->name +
                              " the same time",
                          "several parts a time-step cannot be read; merge them into one .vti");
    return {};
}

} // namespace

core::Result<Series> read_pvd(const std::filesystem::path& file) {
    const std::string name = file.filename().string();
    const VtkMessages messages;
    const auto root = vtkSmartPointer<vtkXMLDataElement>::Take(
        vtkXMLUtilities::ReadElementFromFile(file.c_str()));
    if (auto clean = messages.verdict(name); !clean)
        return tl::unexpected(clean.error());
    auto* collection = root ? root->FindNestedElementWithName("Collection") : nullptr;
    if (collection == nullptr)
        return core::fail(Error::Code::Corrupt, name + " is not a .pvd: it has no Collection");
    Series series{file.stem().string(), "pvd", {}, {file}};
    for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i) {
        auto* element = collection->GetNestedElement(i);
        if (std::strcmp(element->GetName(), "DataSet") != 0)
            continue;
        auto entry = read_entry(*element, file.parent_path(), name);
        if (!entry)
            return tl::unexpected(entry.error());
        series.files.push_back(std::move(*entry));
    }
    if (series.files.empty())
        return core::fail(Error::Code::Corrupt, name + " names no files");
    return sort_by_time(series, name).map([&] { return std::move(series); });
}

} // namespace wakesurf::server
