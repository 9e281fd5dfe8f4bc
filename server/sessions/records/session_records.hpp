// The contents of a session as plain values: rakes, surfaces' parameters, slices, streamlines, bookmarks, annotations. Any kind
// of record is found, put and taken away by its key, so that undo, the journal and restoring need to know
// no kind.
#pragma once

#include "core/base/result.hpp"
#include "protocol/api/generated/annotation.hpp"
#include "protocol/api/generated/bookmark.hpp"
#include "protocol/api/generated/lines.hpp"
#include "protocol/api/generated/rake.hpp"
#include "protocol/api/generated/slice.hpp"
#include "protocol/api/generated/surface.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

namespace wakesurf::server {

using Record = std::variant<protocol::RakeRecord,
                            protocol::SurfaceRecord,
                            protocol::SliceRecord,
                            protocol::LinesRecord,
                            protocol::BookmarkRecord,
                            protocol::AnnotationRecord>;

/// Lists the types in the order of Record's alternatives, in which they can be put: a surface hangs on
/// rakes.
enum class RecordType : std::uint8_t { Rake, Surface, Slice, Lines, Bookmark, Annotation };

inline constexpr std::array<RecordType, 6> record_types{
    RecordType::Rake,  RecordType::Surface,  RecordType::Slice,
    RecordType::Lines, RecordType::Bookmark, RecordType::Annotation};

/// `rake`, `surface`, `slice`, `lines`, `bookmark`, `annotation`; with static storage.
std::string_view name(RecordType type);

/// The type of the records of class R.
template <class R>
inline constexpr auto
    type_of_record = static_cast<RecordType>(Record(std::in_place_type<R>).index());

struct RecordKey {
    RecordType type = RecordType::Rake;
    std::string id;

    auto operator<=>(const RecordKey&) const = default;
};

/// Says that a session has no such record. Error: NotFound, always.
tl::unexpected<core::Error> no_record(const RecordKey& key);

/// Returns how many of a type a session may have.
std::size_t most_records(RecordType type);

RecordKey key_of(const Record& record);
std::uint64_t rev_of(const Record& record);
void set_rev(Record& record, std::uint64_t rev);

/// Returns about how many bytes it takes in memory; as text about three times as much.
std::size_t bytes_of(const Record& record);

/// Holds a record before and after an edit; null where there is none.
struct RecordChange {
    RecordKey key;
    std::shared_ptr<const Record> before;
    std::shared_ptr<const Record> after;
};

class SessionRecords {
  public:
    template <class R>
    using Table = std::map<std::string, R>;

    template <class R>
    const Table<R>& all() const {
        return std::get<Table<R>>(tables_);
    }

    template <class R>
    const R* find(const std::string& id) const {
        const auto found = all<R>().find(id);
        return found == all<R>().end() ? nullptr : &found->second;
    }

    /// Error: NotFound if no record of this type has the id.
    template <class R>
    core::Result<R> get(const std::string& id) const {
        const R* const record = find<R>(id);
        return record != nullptr ? core::Result<R>(*record) : no_record({type_of_record<R>, id});
    }

    /// Returns null where there is none.
    std::shared_ptr<const Record> find(const RecordKey& key) const;

    /// Returns the revision of the record, 0 where there is none.
    std::uint64_t rev(const RecordKey& key) const;

    std::size_t count(RecordType type) const;

    /// Return bytes_of all, and of one, 0 where there is none.
    std::size_t bytes() const { return bytes_; }

    std::size_t bytes(const RecordKey& key) const;
    bool empty() const;

    /// Lists every record, rakes first.
    std::vector<Record> list() const;

    /// Returns the ids of the surfaces that hang on a rake.
    std::vector<std::string> hanging_on(const std::string& rake) const;

    /// Returns whether the rakes a surface names are there.
    bool holds_rakes_of(const protocol::SurfaceRecord& surface) const;

    /// Returns the colour for a new rake: one that no other has, or few.
    std::string free_colour() const;

    void put(const Record& record);
    void erase(const RecordKey& key);

    /// Ids of a type are r1, r2, ..., and none is given twice, not even after a restart.
    std::string new_id(RecordType type);

    std::uint64_t next_number(RecordType type) const {
        return next_[static_cast<std::size_t>(type)];
    }

    /// Numbers below `next` count as given.
    void skip_numbers(RecordType type, std::uint64_t next);

    /// Returns the number of an id, 0 for what new_id never gives.
    static std::uint64_t number_of(const RecordKey& key);

  private:
    std::tuple<Table<protocol::RakeRecord>,
               Table<protocol::SurfaceRecord>,
               Table<protocol::SliceRecord>,
               Table<protocol::LinesRecord>,
               Table<protocol::BookmarkRecord>,
               Table<protocol::AnnotationRecord>>
        tables_;
    std::array<std::uint64_t, 6> next_{1, 1, 1, 1, 1, 1};
    std::size_t bytes_ = 0;
};

} // namespace wakesurf::server
