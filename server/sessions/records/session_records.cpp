#include "server/sessions/records/session_records.hpp"

#include "server/base/limits.hpp"
#include "server/base/numbered_id.hpp"
#include "server/sessions/records/colours.hpp"

#include <algorithm>

namespace wakesurf::server {

namespace {

constexpr std::string_view id_letters = "rsclba"; // a slice is a cut

char letter(RecordType type) {
    return id_letters[static_cast<std::size_t>(type)];
}

const std::string& record_id(const protocol::RakeRecord& record) {
    return record.rake;
}

const std::string& record_id(const protocol::SurfaceRecord& record) {
    return record.surface;
}

const std::string& record_id(const protocol::SliceRecord& record) {
    return record.slice;
}

const std::string& record_id(const protocol::LinesRecord& record) {
    return record.lines;
}

const std::string& record_id(const protocol::BookmarkRecord& record) {
    return record.bookmark;
}

const std::string& record_id(const protocol::AnnotationRecord& record) {
    return record.annotation;
}

std::size_t extra_bytes(const protocol::RakeRecord& record) {
    return record.shape.points.size() * sizeof(core::Vec3) + record.name.size() +
           record.author.size();
}

std::size_t extra_bytes(const protocol::SurfaceRecord& record) {
    std::size_t bytes = record.dataset.size();
    if (record.twin && record.twin->dataset)
        bytes += record.twin->dataset->size();
    for (const std::string& field : record.fields)
        bytes += sizeof(std::string) + field.size();
    return bytes;
}

std::size_t extra_bytes(const protocol::SliceRecord& record) {
    return record.dataset.size() + record.field.size() + (record.minus ? record.minus->size() : 0);
}

std::size_t extra_bytes(const protocol::LinesRecord& record) {
    return record.dataset.size() + record.field.size() +
           record.places.points.size() * sizeof(core::Vec3);
}

std::size_t extra_bytes(const protocol::BookmarkRecord& record) {
    return record.name.size() + record.view.size();
}

std::size_t extra_bytes(const protocol::AnnotationRecord& record) {
    return record.text.size() + record.author.size();
}

/// Calls `found` with a pointer to the record, null where there is none.
template <class Found>
auto look_up(const SessionRecords& records, const RecordKey& key, const Found& found) {
    switch (key.type) {
    case RecordType::Surface:
        return found(records.find<protocol::SurfaceRecord>(key.id));
    case RecordType::Slice:
        return found(records.find<protocol::SliceRecord>(key.id));
    case RecordType::Lines:
        return found(records.find<protocol::LinesRecord>(key.id));
    case RecordType::Bookmark:
        return found(records.find<protocol::BookmarkRecord>(key.id));
    case RecordType::Annotation:
        return found(records.find<protocol::AnnotationRecord>(key.id));
    case RecordType::Rake:
        break;
    }
    return found(records.find<protocol::RakeRecord>(key.id));
}

} // namespace

std::string_view name(RecordType type) {
    constexpr std::array<std::string_view, 6> names{"rake",  "surface",  "slice",
                                                    "lines", "bookmark", "annotation"};
    return names[static_cast<std::size_t>(type)];
}

tl::unexpected<core::Error> no_record(const RecordKey& key) {
    const std::string type(name(key.type));
    return core::fail(core::Error::Code::NotFound,
                      "there is no " + type + " `" + key.id.substr(0, 64) + "`",
                      "`" + type + ".list` lists them");
}

std::size_t most_records(RecordType type) {
    constexpr std::array<std::size_t, 6> counts{limits::rakes,     limits::surfaces,
                                                limits::slices,    limits::lines,
                                                limits::bookmarks, limits::annotations};
    return counts[static_cast<std::size_t>(type)];
}

RecordKey key_of(const Record& record) {
    return {static_cast<RecordType>(record.index()),
            std::visit([](const auto& each) { return record_id(each); }, record)};
}

std::uint64_t rev_of(const Record& record) {
    return std::visit([](const auto& each) { return each.rev; }, record);
}

void set_rev(Record& record, std::uint64_t rev) {
    std::visit([rev](auto& each) { each.rev = rev; }, record);
}

std::size_t bytes_of(const Record& record) {
    return sizeof(Record) + std::visit([](const auto& each) { return extra_bytes(each); }, record);
}

std::shared_ptr<const Record> SessionRecords::find(const RecordKey& key) const {
    return look_up(*this, key, [](const auto* record) {
        return record == nullptr ? nullptr : std::make_shared<const Record>(*record);
    });
}

std::uint64_t SessionRecords::rev(const RecordKey& key) const {
    return look_up(*this, key, [](const auto* record) {
        return record == nullptr ? std::uint64_t{0} : record->rev;
    });
}

std::size_t SessionRecords::bytes(const RecordKey& key) const {
    return look_up(*this, key, [](const auto* record) {
        return record == nullptr ? std::size_t{0} : sizeof(Record) + extra_bytes(*record);
    });
}

std::size_t SessionRecords::count(RecordType type) const {
    const std::array<std::size_t, 6> sizes = std::apply(
        [](const auto&... table) { return std::array<std::size_t, 6>{table.size()...}; }, tables_);
    return sizes[static_cast<std::size_t>(type)];
}

bool SessionRecords::empty() const {
    return std::all_of(record_types.begin(), record_types.end(),
                       [this](RecordType type) { return count(type) == 0; });
}

std::vector<Record> SessionRecords::list() const {
    std::vector<Record> out;
    const auto add = [&](const auto& table) {
        for (const auto& [id, record] : table)
            out.emplace_back(record);
    };
    std::apply([&](const auto&... table) { (add(table), ...); }, tables_);
    return out;
}

std::vector<std::string> SessionRecords::hanging_on(const std::string& rake) const {
    std::vector<std::string> out;
    for (const auto& [id, surface] : all<protocol::SurfaceRecord>())
        if (surface.rake == rake || surface.rake2 == rake)
            out.push_back(id);
    return out;
}

bool SessionRecords::holds_rakes_of(const protocol::SurfaceRecord& surface) const {
    const auto& rakes = all<protocol::RakeRecord>();
    return (!surface.rake || rakes.contains(*surface.rake)) &&
           (!surface.rake2 || rakes.contains(*surface.rake2));
}

std::string SessionRecords::free_colour() const {
    ColourCount count;
    for (const auto& [id, rake] : all<protocol::RakeRecord>())
        count.add(rake.colour);
    return count.rarest();
}

void SessionRecords::put(const Record& record) {
    bytes_ = bytes_ - bytes(key_of(record)) + bytes_of(record);
    std::visit(
        [this](const auto& each) {
            using R = std::decay_t<decltype(each)>;
            std::get<Table<R>>(tables_)[record_id(each)] = each;
        },
        record);
}

void SessionRecords::erase(const RecordKey& key) {
    bytes_ -= bytes(key);
    std::size_t type = 0;
    const auto erase_from = [&](auto& table) {
        if (type++ == static_cast<std::size_t>(key.type))
            table.erase(key.id);
    };
    std::apply([&](auto&... table) { (erase_from(table), ...); }, tables_);
}

std::string SessionRecords::new_id(RecordType type) {
    return letter(type) + std::to_string(next_[static_cast<std::size_t>(type)]++);
}

void SessionRecords::skip_numbers(RecordType type, std::uint64_t next) {
    std::uint64_t& mine = next_[static_cast<std::size_t>(type)];
    mine = std::max(mine, next);
}

std::uint64_t SessionRecords::number_of(const RecordKey& key) {
    const char start = letter(key.type);
    return server::number_of(key.id, {&start, 1}).value_or(0);
}

} // namespace wakesurf::server
