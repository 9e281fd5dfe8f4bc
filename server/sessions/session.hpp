// A session: the records several people look at and edit together. Edits are whole records, the server puts
// them in order and the last writer wins; each bumps seq, goes to the journal and is told to every
// participant. Knows neither sockets nor JSON text.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/result.hpp"
#include "server/base/loop.hpp"
#include "server/base/session_services.hpp"
#include "server/data/datasets.hpp"
#include "server/sessions/people/participants.hpp"
#include "server/sessions/records/author.hpp"
#include "server/sessions/records/change_log.hpp"
#include "server/sessions/records/history.hpp"
#include "server/sessions/records/leases.hpp"
#include "server/sessions/records/observer.hpp"
#include "server/sessions/records/record_entries.hpp"
#include "server/sessions/records/session_records.hpp"
#include "server/sessions/session_clock.hpp"
#include "server/sessions/session_profile.hpp"
#include "server/sessions/surface_builds.hpp"

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::server {

/// Tells whether a session is in use: by a connected client, a reader of a surface, an unanswered call, wait
/// or download, or a call a moment ago. A session that is not in use neither plays nor computes, and
/// releases its memory.
/// Loop thread only. Costs a timer while the session is in use, and nothing afterwards.
class Attendance {
  public:
    static constexpr std::chrono::seconds nobody{20};    ///< without a client: then it is empty
    static constexpr std::chrono::seconds look_every{4}; ///< found out so much later at most

    struct Events {
        std::function<bool()> somebody; ///< says whether a client is seen just now
        std::function<void()> empty;    ///< called once it is empty
        std::function<void()> back;     ///< called when a client comes after that
    };

    Attendance(Loop& loop, const core::Clock& clock, Events events)
        : loop_(loop), clock_(clock), events_(std::move(events)) {}

    Attendance(const Attendance&) = delete;
    Attendance& operator=(const Attendance&) = delete;

    /// Notes that a client asks for something, or has just gone.
    void seen();

    /// Returns a token: the session is in use for as long as a caller holds it, while it waits for an
    /// answer.
    std::shared_ptr<void> stay();

    /// Ends it: no client comes any more.
    void end() { look_.reset(); }

  private:
    void look();
    void look_later();

    Loop& loop_;
    const core::Clock& clock_;
    Events events_;
    std::shared_ptr<void> look_; ///< the timer; null: no client is there
    std::weak_ptr<void> stay_;   ///< shared by all tokens of stay()
    std::chrono::steady_clock::time_point seen_{};
    bool empty_ = false;
};

struct RakeChange {
    protocol::RakeRecord record;
    /// The surfaces that are recomputed, with their new epochs.
    std::vector<std::pair<std::string, std::uint32_t>> surfaces;
};

/// Tells what came of undo or redo. With neither changes nor skipped there was nothing to undo or redo.
struct HistoryMoveResult {
    struct Skip {
        RecordKey key;
        std::string why; ///< for people
    };

    std::vector<RecordChange> changes;
    std::vector<Skip> skipped; ///< records changed by another since: the edit is forgotten
    History::Depth left;
};

/// Loop thread only. An author may be left out: then it is the server's own edit, which cannot be undone.
class Session {
  public:
    /// @param copier  the link of the maker of a copy, with whose other copies it shares turns in the pool and
    ///                room for records; empty: no copy by a link
    Session(std::string id,
            std::string name,
            SessionServices services,
            std::uint32_t& next_number,
            std::string copier = {});
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    const std::string& id() const { return id_; }

    const std::string& name() const { return name_; }

    const std::string& copier() const { return copier_; }

    /// Returns the units that participants entered.
    const protocol::SessionUnits& units() const { return units_; }

    std::uint64_t seq() const { return seq_; }

    Participants& participants() { return participants_; }

    const Participants& participants() const { return participants_; }

    const SessionRecords& records() const { return records_; }

    /// Says since when it is there, who was in it, whether it was edited.
    const protocol::SessionProfile& profile() const { return profile_.value(); }

    /// Returns the picture that a list shows, in base64; empty: none was sent.
    const std::string& thumbnail() const { return thumbnail_; }

    SessionClock& clock() { return clock_; }

    const SessionClock& clock() const { return clock_; }

    /// Returns what ChangeLog::since does, with the clock as it is now.
    std::optional<std::vector<Patch>> changes_since(std::uint64_t seq) const;

    /// Error: NotFound if no surface has the id.
    core::Result<std::shared_ptr<LiveSurface>> live(const std::string& id) const;

    /// Works like Participants::join; the profile remembers the participant.
    core::Result<Joined> join(const Arrival& arrival, Observer& observer);
    void leave(const Observer& observer);
    void lose(const Observer& observer);

    /// Renames it, and tells all participants.
    void rename(std::string name);
    void set_units(protocol::SessionUnits units);
    void set_thumbnail(std::string base64);

    /// Notes that a client calls, or waits for an answer: see Attendance.
    Attendance& attendance() { return attendance_; }

    /// Notes that it was made on purpose: it is never given up, however little is in it.
    void made_on_purpose();

    /// Creates or replaces a rake and rebuilds the surfaces that hang on it, as rake or as rake2; `dragging`
    /// takes, renews or ends the lease. The caller checks whether another participant has it. Error:
    /// NotFound, OverLimit, InvalidArgument, OutOfDomain by how much; nothing has changed then.
    core::Result<RakeChange> set_rake(const protocol::RakeSetting& setting,
                                      const Author& author = {});

    /// Creates or replaces a surface and starts building it. Error: NotFound (surface, rake, dataset),
    /// Unsupported (kind), OutOfTime, OutOfDomain, InvalidArgument, OverLimit.
    core::Result<protocol::SurfaceRecord> set_surface(const protocol::SurfaceSetting& setting,
                                                      const Author& author = {});

    /// Creates or replaces a slice. Error: NotFound (slice, dataset), InvalidArgument (the field), OutOfDomain
    /// where the plane misses the dataset, OverLimit.
    core::Result<protocol::SliceRecord> set_slice(const protocol::SliceSetting& setting,
                                                  const Author& author = {});

    /// Creates or replaces a set of streamlines. Error: NotFound (lines, dataset), InvalidArgument (the field, the seeds, the range),
    /// OutOfDomain where all seeds lie beside the dataset, OverLimit.
    core::Result<protocol::LinesRecord> set_lines(const protocol::LinesSetting& setting,
                                                  const Author& author = {});

    /// Error: NotFound, OverLimit.
    core::Result<protocol::BookmarkRecord> set_bookmark(const protocol::BookmarkSetting& setting,
                                                        const Author& author = {});

    /// Creates or replaces an annotation. A new one carries the author's name, and keeps it. Error: NotFound
    /// (annotation, surface), OverLimit.
    core::Result<protocol::AnnotationRecord>
    set_annotation(const protocol::AnnotationSetting& setting, const Author& author = {});

    /// Deletes a record, and with a rake the surfaces that hang on it. Error: NotFound if there is none.
    core::Result<void> remove(const RecordKey& key, const Author& author = {});

    /// Takes the author's newest edit back, or does it again, as an edit like any other. Where a record of
    /// it is no longer as the author left it, nothing happens but that the edit is forgotten.
    HistoryMoveResult move_in_history(HistoryMove move, const Author& author);

    /// Returns the participant who drags a rake just now.
    std::optional<Lease> lease(const std::string& rake) const { return leases_.find(rake); }

    const SurfaceBuilds& builds() const { return builds_; }

    /// Ends the leases of a participant who has left.
    void end_leases(const std::string& participant);

    /// Works like SurfaceBuilds::dataset_changed. Where its values are not those that the session was last
    /// used with, also by an earlier server, its picture goes, and newcomers are told.
    void dataset_changed(const std::string& dataset);

    /// Lists the datasets whose values have been replaced while no participant was here.
    const std::set<std::string>& replaced_data() const { return replaced_data_; }

    /// Brings back what a journal kept, places of people and all, into a session without records. Its epochs
    /// and seq are above all told before.
    RestoreReport restore(std::span<const JournalEntry> entries);

    /// Lists the records that starts could not use, oldest first.
    const std::vector<KeptAside>& kept_aside() const { return aside_; }

    /// Says how many of them only the last start found.
    std::size_t newly_aside() const { return newly_aside_; }

    /// Has records that cannot be used kept aside, and remembers them.
    void set_aside(const std::vector<RefusedEntry>& refused);

    /// Remembers what is kept aside already. `fresh`: since this start.
    void recall_aside(std::vector<KeptAside> records, bool fresh);

    /// Takes over another session's records as they are, into a session without records.
    void copy(const Session& other, bool on_purpose);

    /// Writes the session into the journal as it is, name and all.
    void keep();

    /// Returns all that the journal has of it but its share links: restore() makes the same session of it.
    std::vector<JournalEntry> entries() const;

    /// Takes over records that have been checked, into a session without records; its surfaces rest until
    /// someone looks.
    void take_over(StoredRecords records);

    /// Notes since when it is in the trash; nothing: it is not any more.
    void delete_at(std::optional<std::int64_t> when);

    /// Ends a deleted session: its people are sent away, its jobs stopped, and nothing of it is kept any
    /// more.
    void end();

    /// Writes the time into the journal if the clock runs: otherwise it is there already.
    void keep_time();

  private:
    using Epochs = std::vector<std::pair<std::string, std::uint32_t>>; ///< of surfaces

    RecordChange change_to(Record after) const;
    std::vector<RecordChange> deletion(const RecordKey& key) const;
    core::Result<void> may_put(const RecordKey& key, bool is_new) const;
    core::Result<void> may_keep(const Record& record) const;
    template <class R, class Check>
    core::Result<R>
    set_field_record(R record, bool is_new, const Author& author, const Check& check);
    core::Result<void> has_room(std::size_t before, std::size_t after) const;
    void count_memory();
    core::Result<core::ClippedRake> clip(const protocol::RakeSetting& setting) const;
    core::Result<core::ClippedRake> clip_to(const core::Rake& shape,
                                            const std::string& dataset) const;
    std::uint64_t
    settle_lease(protocol::RakeRecord& record, std::optional<bool> dragging, const Author& author);
    void lease_ended(const std::string& rake);

    /// @param job  of the surface among the changes, where it has been planned already
    Epochs edit(std::vector<RecordChange> changes,
                const Author& author,
                std::uint64_t drag = 0,
                std::optional<SurfaceJob> job = std::nullopt);
    Epochs commit(const std::vector<RecordChange>& changes,
                  std::optional<SurfaceJob> job = std::nullopt);
    Epochs build(const std::vector<RecordChange>& changes,
                 bool rest = false,
                 std::optional<SurfaceJob> job = std::nullopt);
    void begin(std::uint32_t epochs_before, bool rest);
    protocol::SessionHead head() const;
    std::vector<JournalEntry> own_entries() const;
    protocol::SessionProfile profile_of(StoredRecords& kept,
                                        std::span<const JournalEntry> entries) const;
    void time_moved(bool jumped);
    void announce(const std::vector<Patch>& patches);
    void note_data(const std::string& dataset, bool replaced);
    void keep_profile();
    void somebody_went();
    bool somebody() const;
    void rest();
    void resume();
    core::Result<void> may_be_default(RecordType type, bool is_new) const;
    SurfaceBuilds::Events build_events();

    std::vector<HistoryMoveResult::Skip> obstacles(const Edit& edit, HistoryMove move) const;
    std::string obstacle(const Edit& edit, const EditStep& step, HistoryMove move) const;

    std::string id_;
    std::string copier_;
    std::string name_;
    protocol::SessionUnits units_;
    SessionServices services_;
    std::uint64_t seq_ = 0;
    SessionRecords records_;
    Participants participants_;
    ChangeLog changes_;
    Leases leases_;
    History history_;
    SurfaceBuilds builds_; ///< its jobs' events use what is above
    SessionClock clock_;
    ProfileKeeper profile_;
    std::string thumbnail_;
    Attendance attendance_;
    std::chrono::steady_clock::time_point time_kept_{}; ///< of the clock, in the journal
    std::vector<KeptAside> aside_;
    std::size_t newly_aside_ = 0;
    std::set<std::string> replaced_data_;
    core::MemoryAccount::Share memory_; ///< of the records and the history
};

} // namespace wakesurf::server
