#include "store/value_marks.hpp"

#include "store/store_manifest.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <charconv>
#include <span>

namespace wakesurf::store {

namespace {

/// Takes a step of splitmix64: whatever differs before differs after.
std::uint64_t mixed(std::uint64_t so_far, std::uint64_t word) {
    std::uint64_t x = (so_far ^ word) + 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

std::uint64_t mark_of_text(std::string_view text) {
    std::uint64_t mark = text.size();
    for (const char c : text)
        mark = mixed(mark, static_cast<unsigned char>(c));
    return mark;
}

} // namespace

core::Result<ValueMarks> ValueMarks::read(const StoreLayout& layout, const core::Disk& disk) {
    const auto file = layout.folder / checksums_file_name;
    const std::size_t step_bytes = (1 + layout.scalars.size()) * sizeof(std::uint32_t);
    const auto size = disk.size(file);
    if (!size && size.error().code != core::Error::Code::NotFound)
        return tl::unexpected(size.error());
    const std::size_t steps =
        size ? std::min<std::size_t>(*size / step_bytes, layout.times.size()) : 0;
    std::vector<std::uint32_t> records(steps * (1 + layout.scalars.size()));
    if (steps > 0)
        if (auto got = disk.read(file, 0, std::as_writable_bytes(std::span(records))); !got)
            return tl::unexpected(got.error());
    return ValueMarks(layout, std::move(records));
}

ValueMarks::ValueMarks(const StoreLayout& layout, std::vector<std::uint32_t> records)
    : columns_(1 + layout.scalars.size()), records_(std::move(records)) {
    StoreLayout shared = layout;
    shared.times.clear();
    marks_.push_back(mark_of_text(protocol::written(shared).dump()));
    for (std::size_t i = 0; i * columns_ < records_.size(); ++i) {
        std::uint64_t mark = mixed(marks_.back(), std::bit_cast<std::uint64_t>(layout.times[i]));
        for (std::size_t column = 0; column < columns_; ++column)
            mark = mixed(mark, checksum(i, column));
        marks_.push_back(mark);
    }
}

std::string ValueMarks::word(std::size_t steps) const {
    return fmt::format("{}-{:016x}", steps, marks_[steps]);
}

std::string ValueMarks::text() const {
    if (steps() == 0)
        return word(0);
    if (steps() == 1)
        return fmt::format("{} {}", word(0), word(1));
    return fmt::format("{} {} {}", word(0), word(1), word(steps()));
}

bool ValueMarks::continues(const ValueMarks& before) const {
    return before.steps() <= steps() && before.marks_.back() == marks_[before.steps()];
}

bool ValueMarks::contradicts(std::string_view text) const {
    while (!text.empty()) {
        const auto end = std::min(text.find(' '), text.size());
        const std::string_view mark = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        std::size_t count = 0;
        const auto read = std::from_chars(mark.data(), mark.data() + mark.size(), count);
        if (read.ec == std::errc() && count <= steps() && mark != word(count))
            return true;
    }
    return false;
}

} // namespace wakesurf::store
