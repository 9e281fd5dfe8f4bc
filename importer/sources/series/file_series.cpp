#include "importer/sources/series/file_series.hpp"

#include "importer/base/library_messages.hpp"
#include "importer/base/text.hpp"
#include "importer/sources/files/bounded_xml.hpp"
#include "importer/sources/files/source_files.hpp"
#include "importer/sources/series/numbered_files.hpp"
#include "importer/sources/series/series_times.hpp"

#include <nlohmann/json.hpp>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>

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
    SeriesEntry entry{{{*path, name_for_messages(file), {}}}, std::nullopt, {}};
    if (const auto time = element.find("time"); time != element.end()) {
        if (!time->is_number() || !std::isfinite(time->get<double>()))
            return core::fail(Error::Code::Corrupt, series + " gives " + file + " the time '" +
                                                        time->dump() +
                                                        "', which is not a finite number");
        entry.time = time->get<double>();
    }
    return entry;
}

struct DataSetElement {
    ListedFile file;
    std::optional<double> time;
    std::string part;      ///< the name that distinguishes it from other parts of its time-step
    std::size_t place = 0; ///< in the file
};

core::Result<DataSetElement> read_element(vtkXMLDataElement& element,
                                          const std::filesystem::path& folder,
                                          const std::string& pvd) {
    const std::string file = xml_attribute(element, "file");
    if (file.empty())
        return core::fail(Error::Code::Corrupt, pvd + " has a DataSet without a file");
    const auto path = named_path(folder, file, pvd);
    if (!path)
        return tl::unexpected(path.error());
    DataSetElement out{
        {*path, name_for_messages(file), xml_attribute(element, "name")}, std::nullopt, {}};
    out.part = xml_attribute(element, "group") + '\n' + xml_attribute(element, "part") + '\n' +
               xml_attribute(element, "name");
    if (element.GetAttribute("timestep") == nullptr)
        return out;
    const std::string time = xml_attribute(element, "timestep");
    out.time = finite_number(time);
    if (!out.time)
        return core::fail(Error::Code::Corrupt, pvd + " gives " + name_for_messages(file) +
                                                    " the time '" + time +
                                                    "', which is not a finite number");
    return out;
}

std::string text_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string note_on_cut(const std::string& name, std::size_t steps) {
    return name +
           " is not whole, as while a solver writes it or after it was killed: of its time-steps " +
           (steps == 1 ? "the first is" : "the first " + std::to_string(steps) + " are") + " read";
}

struct Elements {
    std::vector<DataSetElement> all;
    bool cut = false; ///< the file ends before they do
};

core::Result<Elements> read_elements(const std::filesystem::path& file) {
    const std::string name = file.filename().string();
    const VtkMessages messages;
    std::string text = text_of(file);
    const auto closed = closed_xml(text);
    std::istringstream in(closed ? *closed : std::move(text));
    const auto parsed = parse_xml(in, name);
    if (!parsed)
        return tl::unexpected(parsed.error());
    vtkXMLDataElement* const root = (*parsed)->GetRootElement();
    if (auto clean = messages.verdict(name); !clean)
        return tl::unexpected(clean.error());
    auto* collection = root ? root->FindNestedElementWithName("Collection") : nullptr;
    if (collection == nullptr)
        return core::fail(Error::Code::Corrupt, name + " is not a .pvd: it has no Collection");
    Elements read{{}, closed.has_value()};
    auto& out = read.all;
    for (int i = 0; i < collection->GetNumberOfNestedElements(); ++i) {
        auto* nested = collection->GetNestedElement(i);
        if (std::strcmp(nested->GetName(), "DataSet") != 0)
            continue;
        auto element = read_element(*nested, file.parent_path(), name);
        if (!element)
            return tl::unexpected(element.error());
        element->place = out.size();
        out.push_back(std::move(*element));
    }
    if (out.empty())
        return core::fail(Error::Code::Corrupt, name + " names no files");
    return read;
}

core::Result<void> sort_by_time(std::vector<DataSetElement>& elements, const std::string& pvd) {
    const auto timed = std::count_if(elements.begin(), elements.end(),
                                     [](const auto& e) { return e.time.has_value(); });
    if (timed == 0)
        return {};
    if (static_cast<std::size_t>(timed) != elements.size())
        return core::fail(Error::Code::Corrupt, pvd + " gives only some of its files a time");
    std::stable_sort(elements.begin(), elements.end(),
                     [](const auto& a, const auto& b) { return *a.time < *b.time; });
    return {};
}

using Group = std::vector<DataSetElement>;

// Returns true for parts without a number: files for one part of one time, next to each other at every time
// and always as many. A restart would have written the times one after the other.
bool are_parts_without_numbers(const std::vector<Group>& times) {
    return std::all_of(times.begin(), times.end(), [&](const Group& group) {
        return group.size() > 1 && group.size() == times.front().size() &&
               std::adjacent_find(group.begin(), group.end(), [](const auto& a, const auto& b) {
                   return a.part != b.part || a.place + 1 != b.place || a.file.path == b.file.path;
               }) == group.end();
    });
}

// Takes the last of a part that is named twice for one time, as after a restart.
SeriesEntry entry_of(Group& group, std::vector<std::string>& left_out) {
    SeriesEntry out{{}, group.front().time, {}};
    std::vector<std::string> parts;
    for (auto& element : group) {
        const auto same = std::find(parts.begin(), parts.end(), element.part);
        if (same == parts.end()) {
            parts.push_back(element.part);
            out.parts.push_back(std::move(element.file));
            continue;
        }
        auto& before = out.parts[static_cast<std::size_t>(same - parts.begin())];
        left_out.push_back(before.name);
        before = std::move(element.file);
    }
    return out;
}

// Returns the JSON of a list of objects that ends too early, up to its last whole one.
std::string closed_list(const std::string& text) {
    std::size_t depth = 0;
    std::size_t whole = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quoted && c == '\\')
            ++i;
        else if (c == '"')
            quoted = !quoted;
        else if (!quoted && (c == '{' || c == '['))
            ++depth;
        else if (!quoted && (c == '}' || c == ']') && depth > 0 && --depth == 2)
            whole = i + 1;
    }
    return text.substr(0, whole) + "]}";
}

std::vector<Group> by_times(std::vector<DataSetElement> elements) {
    std::vector<Group> out;
    for (auto& element : elements) {
        if (out.empty() || !element.time || !same_time(*out.back().front().time, *element.time))
            out.emplace_back();
        out.back().push_back(std::move(element));
    }
    return out;
}

} // namespace

core::Result<FileSeries> read_json_series(const std::filesystem::path& file) {
    const std::string name = file.filename().string();
    if (!std::ifstream(file))
        return core::fail(Error::Code::Io, "cannot open " + name);
    const std::string text = text_of(file);
    json root = json::parse(text, nullptr, false);
    const bool cut = root.is_discarded();
    if (cut)
        root = json::parse(closed_list(text), nullptr, false);
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
    if (cut)
        series.note = note_on_cut(name, series.entries.size());
    return series;
}

core::Result<FileSeries> read_pvd_series(const std::filesystem::path& file) {
    const std::string name = file.filename().string();
    auto elements = read_elements(file);
    if (!elements)
        return tl::unexpected(elements.error());
    if (auto sorted = sort_by_time(elements->all, name); !sorted)
        return tl::unexpected(sorted.error());
    FileSeries series{file.stem().string(), "pvd", {file}, {}};
    auto times = by_times(std::move(elements->all));
    if (elements->cut) { // which parts its last time-step has is not known
        const auto last =
            std::max_element(times.begin(), times.end(), [](const Group& a, const Group& b) {
                return a.back().place < b.back().place;
            });
        if (last->size() < times.front().size())
            times.erase(last);
        series.note = note_on_cut(name, times.size());
    }
    if (are_parts_without_numbers(times))
        return core::fail(Error::Code::Corrupt,
                          name + " gives " + times.front()[0].file.name + " and " +
                              times.front()[1].file.name + " the same time, " +
                              time_text(times.front()[0].time.value_or(0.0)),
                          "give the parts of a time-step different part numbers");
    for (auto& group : times)
        series.entries.push_back(entry_of(group, series.left_out));
    return series;
}

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
