#include "importer/sources/ensight/ensight_case.hpp"

#include "importer/fields/velocity_choice.hpp"
#include "importer/sources/files/source_files.hpp"
#include "importer/sources/series/series_times.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <string_view>

namespace wakesurf::importer {

using core::Error;
using core::FieldInfo;
namespace fs = std::filesystem;

namespace {

template <class T>
bool number(const std::string& word, T& out) {
    const char* const end = word.data() + word.size();
    const auto [at, error] = std::from_chars(word.data(), end, out);
    return at == end && error == std::errc();
}

// Returns words, without the quotes round those that hold blanks.
std::vector<std::string> words_of(const std::string& text) {
    constexpr std::string_view blanks = " \t\r\n\v\f";
    std::vector<std::string> out;
    for (auto at = text.find_first_not_of(blanks); at < text.size();
         at = text.find_first_not_of(blanks, at)) {
        const bool quoted = text[at] == '"' && text.find('"', at + 1) != std::string::npos;
        const auto end =
            std::min(quoted ? text.find('"', at + 1) : text.find_first_of(blanks, at), text.size());
        const auto begin = quoted ? at + 1 : at;
        out.push_back(text.substr(begin, end - begin));
        at = quoted ? end + 1 : end;
    }
    return out;
}

struct Line {
    std::string key; ///< before the colon; empty where there is none
    std::vector<std::string> words;
};

// Returns lines by section, without comments and empty lines.
std::map<std::string, std::vector<Line>> sections_of(std::istream& in) {
    std::map<std::string, std::vector<Line>> out;
    std::string section;
    for (std::string text; std::getline(in, text);) {
        auto words = words_of(text);
        if (words.empty() || words.front().starts_with('#'))
            continue;
        if (words.size() == 1 &&
            words[0].find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ") == std::string::npos) {
            section = words[0];
            continue;
        }
        const auto colon = text.find(':');
        if (colon == std::string::npos) {
            out[section].push_back({{}, std::move(words)});
            continue;
        }
        std::string key;
        for (const auto& word : words_of(text.substr(0, colon)))
            key += (key.empty() ? "" : " ") + word;
        out[section].push_back({key, words_of(text.substr(colon + 1))});
    }
    return out;
}

// Describes the numbers of files in a time set that does not list them.
struct Numbering {
    int start = 0;
    std::optional<int> increment;

    // Appends as many numbers as there are times. Returns false if they are beyond those of files.
    bool apply(EnsightTimeSet& set) const {
        for (std::size_t i = 0; increment && i < set.times.size(); ++i) {
            const auto number = start + static_cast<std::int64_t>(i) * *increment;
            if (number != static_cast<int>(number))
                return false;
            set.numbers.push_back(static_cast<int>(number));
        }
        return true;
    }
};

// Removes times that a restart lists again: the files listed last stay.
core::Result<void> keep_last_of_each_time(EnsightTimeSet& set) {
    std::vector<TimedEntry> entries;
    for (std::size_t i = 0; i < set.times.size(); ++i) {
        if (set.numbers.size() == i)
            set.numbers.push_back(static_cast<int>(i));
        entries.push_back({"file " + std::to_string(set.numbers[i]), set.times[i]});
    }
    return settle_times(std::move(entries)).map([&](SeriesTimes settled) {
        std::vector<int> numbers;
        for (const std::size_t i : settled.order)
            numbers.push_back(set.numbers[i]);
        set.numbers = std::move(numbers);
        set.times = std::move(settled.times);
        set.note = std::move(settled.note);
    });
}

core::Result<std::vector<EnsightTimeSet>> time_sets_of(const std::vector<Line>& lines,
                                                       const std::string& name) {
    std::vector<EnsightTimeSet> out;
    std::vector<Numbering> numberings; // of each
    std::size_t steps = 0;
    std::string reading;
    const auto damaged =
        core::fail(Error::Code::Corrupt, name + " has a time set that cannot be read");
    for (const auto& line : lines) {
        if (!line.key.empty())
            reading = line.key;
        if (line.key == "time set") {
            out.emplace_back();
            numberings.emplace_back();
            if (line.words.empty() || !number(line.words[0], out.back().id))
                return damaged;
            continue;
        }
        if (out.empty())
            return damaged;
        auto& set = out.back();
        for (const auto& word : line.words) {
            int whole = 0;
            double time = 0.0;
            if (reading == "number of steps" && !number(word, steps))
                return damaged;
            if ((reading.starts_with("filename")) && !number(word, whole))
                return damaged;
            if (reading == "filename start number")
                numberings.back().start = whole;
            if (reading == "filename numbers")
                set.numbers.push_back(whole);
            if (reading == "filename increment")
                numberings.back().increment = whole;
            if (reading == "time values") {
                if (!number(word, time) || !std::isfinite(time))
                    return damaged;
                set.times.push_back(time);
            }
        }
        if (reading == "time values" && set.times.size() > steps)
            set.times.resize(steps);
        if (reading == "filename numbers file" || reading == "time values file")
            return core::fail(Error::Code::Unsupported,
                              name + " keeps its times in a file of their own",
                              "write the time values into the case file");
    }
    for (std::size_t i = 0; i < out.size(); ++i)
        if (out[i].numbers.empty() && !numberings[i].apply(out[i]))
            return damaged;
    for (auto& set : out) {
        if (set.times.empty() || (!set.numbers.empty() && set.numbers.size() < set.times.size()))
            return core::fail(Error::Code::Corrupt,
                              name + ": time set " + std::to_string(set.id) +
                                  " does not have times, each with a file number");
        if (auto rising = keep_last_of_each_time(set); !rising)
            return tl::unexpected(rising.error());
    }
    return out;
}

// Parses "[ts] [fs] [description] file": the last word is the file.
core::Result<EnsightFile> file_of(const Line& line, std::size_t names, const std::string& name) {
    if (line.words.size() < names)
        return core::fail(Error::Code::Corrupt,
                          name + ": the line '" + line.key + "' names no file");
    EnsightFile out{line.words.back(), std::nullopt};
    const std::size_t sets = line.words.size() - names;
    int id = 0;
    if (sets > 0 && number(line.words[0], id))
        out.time_set = id;
    if (sets > 1 && number(line.words[1], id))
        return core::fail(Error::Code::Unsupported,
                          name + " keeps several time-steps in one file, which cannot be read",
                          "write one file per time-step");
    return out;
}

const EnsightTimeSet* set_of(const std::vector<EnsightTimeSet>& sets, const EnsightFile& file) {
    const auto found = std::find_if(sets.begin(), sets.end(), [&](const EnsightTimeSet& set) {
        return set.id == file.time_set;
    });
    return found == sets.end() ? nullptr : &*found;
}

core::Result<void> find_variables(EnsightCase& found, const std::vector<Line>& lines) {
    const std::map<std::string, std::pair<int, FieldInfo::Source>> kinds{
        {"scalar per node", {1, FieldInfo::Source::Point}},
        {"vector per node", {3, FieldInfo::Source::Point}},
        {"scalar per element", {1, FieldInfo::Source::Cell}},
        {"vector per element", {3, FieldInfo::Source::Cell}}};
    for (const auto& line : lines) {
        const auto kind = kinds.find(line.key);
        if (kind == kinds.end())
            continue;
        auto file = file_of(line, 2, found.name);
        if (!file)
            return tl::unexpected(file.error());
        if (file->time_set && set_of(found.time_sets, *file) == nullptr)
            return core::fail(Error::Code::Corrupt,
                              found.name + " has no time set " + std::to_string(*file->time_set));
        found.variables.push_back(
            {{line.words[line.words.size() - 2], kind->second.first, kind->second.second, {}, {}},
             std::move(*file)});
    }
    return {};
}

// Takes the times of the velocity; variables without a value at one of them are left out.
core::Result<void> find_times(EnsightCase& found, const std::string& wish) {
    const auto& all = found.variables;
    std::vector<FieldInfo> fields;
    for (const auto& one : all)
        fields.push_back(one.field);
    const auto chosen = choose_velocity(fields, wish);
    auto velocity = std::find_if(all.begin(), all.end(), [&](const EnsightVariable& one) {
        return chosen ? one.field.name == chosen->parts.arrays.front().name
                      : one.field.components == 3;
    });
    if (velocity == all.end())
        velocity = all.begin(); // the error that lists the choice follows once all is read
    if (velocity == all.end())
        return core::fail(Error::Code::NotFound, found.name + " has no vector variable",
                          "write the velocity as `vector per node` or `vector per element`");
    const auto* set = set_of(found.time_sets, velocity->file);
    found.times = set == nullptr ? std::vector<double>{0.0} : set->times;
    found.timeless = set == nullptr;
    found.time_note = set == nullptr ? "" : set->note;
    std::string left_out;
    std::erase_if(found.variables, [&](const EnsightVariable& one) {
        const auto* own = set_of(found.time_sets, one.file);
        if (own == nullptr || std::includes(own->times.begin(), own->times.end(),
                                            found.times.begin(), found.times.end()))
            return false;
        left_out += (left_out.empty() ? "" : ", ") + one.field.name;
        return true;
    });
    if (!left_out.empty())
        found.note = "not at every time-step: " + left_out;
    return {};
}

} // namespace

const EnsightVariable* EnsightCase::find(const FieldInfo& field) const {
    for (const auto& one : variables)
        if (one.field.name == field.name && one.field.source == field.source)
            return &one;
    return nullptr;
}

core::Result<NamedFile> EnsightCase::file_at(const EnsightFile& file, double time) const {
    std::string out = file.pattern;
    const auto* set = set_of(time_sets, file);
    const auto first = out.find('*');
    if (set != nullptr && first != std::string::npos) {
        const auto later = std::upper_bound(set->times.begin(), set->times.end(), time);
        const auto index = later == set->times.begin()
                               ? 0
                               : static_cast<std::size_t>(later - set->times.begin()) - 1;
        const auto count = std::min(out.find_first_not_of('*', first), out.size()) - first;
        std::string digits = std::to_string(set->numbers[index]);
        if (digits.size() < count)
            digits.insert(0, count - digits.size(), '0');
        out.replace(first, count, digits);
    }
    return named_path(folder, out, name).map([&](const fs::path& path) {
        return NamedFile{path, name_for_messages(out)};
    });
}

core::Result<EnsightCase> read_ensight_case(const fs::path& path, const std::string& velocity) {
    const std::string name = path.filename().string();
    std::ifstream in(path);
    if (!in)
        return core::fail(Error::Code::NotFound, name + " is not there or cannot be read");
    return parse_ensight_case(in, path.parent_path(), name, velocity);
}

core::Result<EnsightCase> parse_ensight_case(std::istream& in,
                                             const fs::path& folder,
                                             const std::string& name,
                                             const std::string& velocity) {
    EnsightCase found;
    found.folder = folder;
    found.name = name;
    auto sections = sections_of(in);
    const auto& format = sections["FORMAT"];
    if (format.empty() || format[0].key != "type" || format[0].words.empty() ||
        format[0].words[0] != "ensight")
        return core::fail(Error::Code::Corrupt, found.name + " is not an EnSight case file");
    if (format[0].words.size() < 2 || format[0].words[1] != "gold")
        return core::fail(Error::Code::Unsupported, found.name + " is in the format of EnSight 6",
                          "write EnSight Gold");
    if (sections.contains("FILE"))
        return core::fail(Error::Code::Unsupported,
                          found.name +
                              " keeps several time-steps in one file, which cannot be read",
                          "write one file per time-step");
    auto sets = time_sets_of(sections["TIME"], found.name);
    if (!sets)
        return tl::unexpected(sets.error());
    found.time_sets = std::move(*sets);
    for (const auto& line : sections["GEOMETRY"])
        if (line.key == "model") {
            auto words = line;
            if (!words.words.empty() && words.words.back() == "change_coords_only")
                words.words.pop_back();
            auto file = file_of(words, 1, found.name);
            if (!file)
                return tl::unexpected(file.error());
            found.geometry = std::move(*file);
        }
    if (found.geometry.pattern.empty())
        return core::fail(Error::Code::Corrupt, found.name + " names no geometry file");
    if (auto ok = find_variables(found, sections["VARIABLE"]); !ok)
        return tl::unexpected(ok.error());
    if (auto ok = find_times(found, velocity); !ok)
        return tl::unexpected(ok.error());
    return found;
}

} // namespace wakesurf::importer
