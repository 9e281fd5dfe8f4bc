#include "store/stored_means.hpp"

#include "core/base/crc32c.hpp"
#include "core/dataset/time_means.hpp"
#include "protocol/api/base/json_members.hpp"
#include "protocol/api/dataset_json.hpp"
#include "store/finite_values.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace wakesurf::store {

using core::Error;
using core::Result;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

std::string field_stem(const std::string& stem, std::size_t field) {
    return fmt::format("{}_{}", stem, field);
}

std::string means_text(const std::vector<StoredMean>& means) {
    json all = json::array();
    for (const StoredMean& each : means) {
        json one = protocol::written(each.record);
        one["stem"] = each.stem;
        one["source"] = each.source;
        one["checksums"] = each.sums;
        all.push_back(std::move(one));
    }
    return kept_text(means_list, all);
}

Result<StoredMean> parse_one(const json& value) {
    protocol::JsonReader in(value);
    StoredMean mean;
    members(in, mean.record);
    in.needed("stem", mean.stem);
    in.needed("source", mean.source);
    in.needed("checksums", mean.sums);
    if (!is_stem(means_list, mean.stem))
        in.check("stem", "is no beginning of a file name");
    if (mean.sums.size() != mean.record.fields.size() ||
        std::ranges::any_of(mean.sums,
                            [&](const auto& each) { return each.size() != mean.files(); }))
        in.check("checksums", "must be one a file");
    if (mean.record.fields.empty() || mean.record.fields.size() > most_fields)
        in.check("fields", "must be at least one, and as many as a mean has at most");
    if (mean.record.phases > most_phases)
        in.check("phases", "are more than a mean has");
    if (mean.record.phases != 0 && !(mean.record.period > 0.0))
        in.check("period", "must be more than 0");
    return in.verdict().map([&] { return std::move(mean); });
}

std::vector<std::string>
files_of(const StoreLayout& layout, const std::string& stem, std::size_t index) {
    std::vector<std::string> names;
    for (const StepFile& file : step_files(layout, stem, 1, core::Precision::Single, index))
        names.push_back(file.name);
    return names;
}

void remove_unlisted(const fs::path& folder,
                     const FolderChanges& changes,
                     const std::vector<StoredMean>& listed) {
    std::error_code error;
    std::vector<std::string> gone;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        const std::string name = entry.path().filename().string();
        const std::string stem = name.substr(0, name.find('_', means_list.stem.size()));
        if (is_stem(means_list, stem) && stem.size() < name.size() &&
            std::ranges::find(listed, stem, &StoredMean::stem) == listed.end())
            gone.push_back(name);
    }
    for (const std::string& name : gone)
        changes.remove(name);
}

} // namespace

std::vector<KeptColumn> columns_of(const StoredMean& mean, const std::vector<double>& times) {
    std::vector<std::uint32_t> files(times.size(), 0);
    if (mean.record.phases != 0)
        std::ranges::transform(times, files.begin(), [&](double time) {
            return static_cast<std::uint32_t>(
                core::phase_of(time, mean.record.period, mean.record.phases));
        });
    std::vector<KeptColumn> columns;
    for (std::size_t field = 0; field < mean.sums.size(); ++field)
        columns.push_back({field_stem(mean.stem, field), files, mean.sums[field]});
    return columns;
}

std::vector<std::size_t> steps_between(const std::vector<double>& times, double from, double to) {
    std::vector<std::size_t> steps;
    for (std::size_t i = 0; i < times.size(); ++i)
        if (times[i] >= from && times[i] <= to)
            steps.push_back(i);
    return steps;
}

std::optional<std::uint32_t>
source_mark(const ValueMarks& now, std::span<const std::size_t> steps, std::size_t column) {
    std::vector<std::uint32_t> sums;
    for (const std::size_t step : steps) {
        if (step >= now.steps())
            return std::nullopt;
        sums.push_back(now.checksum(step, column));
    }
    return core::crc32c(std::as_bytes(std::span(sums)));
}

Result<std::vector<StoredMean>> read_means(const fs::path& folder, const core::Disk& disk) {
    const auto entries = read_kept(means_list, folder, disk);
    if (!entries)
        return tl::unexpected(entries.error());
    if (entries->size() > most_means)
        return tl::unexpected(damaged(
            means_list, {Error::Code::Corrupt, "it lists more means than a store has", ""}));
    std::vector<StoredMean> means;
    for (const json& each : *entries) {
        auto mean = parse_one(each);
        if (!mean)
            return tl::unexpected(damaged(means_list, mean.error()));
        means.push_back(std::move(*mean));
    }
    return means;
}

std::vector<StoredMean>
current_means(std::vector<StoredMean> means, const StoreLayout& layout, const ValueMarks& now) {
    std::erase_if(means, [&](const StoredMean& each) {
        const auto scalar = find_scalar(layout, each.record.of);
        const auto steps = steps_between(layout.times, each.record.from, each.record.to);
        return steps.size() != each.record.steps ||
               source_mark(now, steps, scalar ? 1 + *scalar : 0) != each.source;
    });
    return means;
}

Result<MeanWriter> MeanWriter::begin(const StoreLayout& layout, const ValueMarks& now) {
    auto changes = FolderChanges::begin(layout.folder, FolderChanges::IfLocked::Refuse);
    if (!changes)
        return tl::unexpected(changes.error());
    auto means = read_means(layout.folder, core::PosixDisk());
    if (!means)
        return tl::unexpected(means.error());
    MeanWriter writer(layout, std::move(*changes));
    writer.before_ = std::move(*means);
    writer.there_ = current_means(writer.before_, layout, now);
    remove_unlisted(layout.folder, writer.changes_, writer.before_);
    writer.mean_.stem = unused_stem(means_list, layout.folder);
    return writer;
}

MeanWriter::~MeanWriter() {
    for (const std::string& name : written_)
        changes_.remove(name);
}

Result<void> MeanWriter::begin_files(std::size_t fields) {
    mean_.sums.resize(fields);
    for (std::size_t field = 0; field < fields; ++field) {
        auto file = changes_.file(files_of(layout_, field_stem(mean_.stem, field), next_).front());
        if (!file)
            return tl::unexpected(file.error());
        open_.push_back({std::move(*file)});
        if (layout_.brick_cells != 0)
            open_.back().bricks.emplace(layout_.bricks().count());
    }
    return {};
}

Result<void> MeanWriter::append(std::size_t field, std::span<const float> values) {
    Open& to = open_[field];
    if (!to.bricks)
        to.sum = core::crc32c(std::as_bytes(values), to.sum);
    const std::size_t brick = to.bricks ? layout_.bricks().nodes_per_brick() : values.size();
    for (std::size_t at = 0; to.bricks && at < values.size(); at += brick, ++to.brick) {
        const auto bytes = std::as_bytes(values.subspan(at, brick));
        to.bricks->checksums[to.brick] = core::crc32c(bytes);
        to.bricks->gaps[to.brick] = all_finite(bytes, core::Precision::Single) ? 0 : 1;
    }
    return to.values.append(std::as_bytes(values));
}

Result<void> MeanWriter::end_files() {
    Result<void> outcome;
    for (std::size_t field = 0; field < open_.size() && outcome; ++field) {
        const auto names = files_of(layout_, field_stem(mean_.stem, field), next_);
        Open& one = open_[field];
        written_.insert(written_.end(), names.begin(), names.end());
        outcome = one.values.finish();
        if (outcome && one.bricks) {
            const auto index = brick_index_bytes(*one.bricks);
            one.sum = core::crc32c(index);
            outcome = changes_.write(names[1], index);
        }
        mean_.sums[field].push_back(one.sum);
    }
    open_.clear();
    ++next_;
    return outcome;
}

Result<void> MeanWriter::keep(core::MeanRecord record, std::uint32_t source) {
    if (there_.size() >= most_means)
        return core::over_limit(
            most_means, fmt::format("the dataset has {} means already", most_means), "remove one");
    mean_.record = std::move(record);
    mean_.source = source;
    auto all = there_;
    all.push_back(mean_);
    const std::string text = means_text(all);
    auto written = changes_.write(std::string(means_list.file), std::as_bytes(std::span(text)));
    if (!written)
        return written;
    written_.clear();
    remove_unlisted(layout_.folder, changes_, all);
    return {};
}

Result<void> remove_mean(const fs::path& folder, std::string_view name) {
    const auto changes = FolderChanges::begin(folder, FolderChanges::IfLocked::Refuse);
    if (!changes)
        return tl::unexpected(changes.error());
    auto all = read_means(folder, core::PosixDisk());
    if (!all)
        return tl::unexpected(all.error());
    const auto gone = std::erase_if(*all, [&](const StoredMean& each) {
        return std::ranges::find(each.record.fields, name, &core::MeanField::name) !=
               each.record.fields.end();
    });
    if (gone == 0)
        return core::fail(Error::Code::NotFound, fmt::format("there is no mean {}", name),
                          "`dataset.describe` lists those there are");
    const std::string text = means_text(*all);
    return changes->write(std::string(means_list.file), std::as_bytes(std::span(text))).map([&] {
        remove_unlisted(folder, *changes, *all);
    });
}

} // namespace wakesurf::store
