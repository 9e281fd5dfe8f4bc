#include "server/sessions/session.hpp"

#include "core/base/plain_text.hpp"
#include "core/surface/rake.hpp"
#include "protocol/api/plural.hpp"
#include "server/base/limits.hpp"
#include "server/live/compute/budgets.hpp"
#include "server/sessions/records/record_room.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace wakesurf::server {

core::Result<Joined> Session::join(const Arrival& arrival, Observer& observer) {
    auto joined = participants_.join(arrival, observer);
    if (joined) {
        profile_.arrived({joined->you.id, joined->you.name, joined->you.colour});
        keep_profile();
        attendance_.seen();
    }
    return joined;
}

void Session::leave(const Observer& observer) {
    participants_.leave(observer);
    somebody_went();
}

void Session::lose(const Observer& observer) {
    participants_.lose(observer);
    somebody_went();
}

/// Notes that a client went. A client that only reloads the page finds the session as it was.
void Session::somebody_went() {
    profile_.used();
    keep_profile();
    attendance_.seen();
}

bool Session::somebody() const {
    bool found = !participants_.present().empty();
    builds_.for_each([&](const LiveSurface& each) { found = found || each.has_viewers(); });
    return found;
}

/// Stops a clock that no client looks at: it would have surfaces computed for ever, and what they keep
/// belongs to others.
void Session::rest() {
    clock_.pause();
    builds_.for_each([](LiveSurface& each) { each.put_to_rest(); });
}

/// Computes again from the beginning what was being computed; the rest is built when a client looks.
void Session::resume() {
    builds_.for_each([](LiveSurface& each) { each.resume(); });
}

void Session::rename(std::string name) {
    name_ = std::move(name);
    profile_.made_on_purpose();
    announce({SessionName{id_, name_, units_}});
}

void Session::set_units(protocol::SessionUnits units) {
    units_ = std::move(units);
    profile_.edited();
    announce({SessionName{id_, name_, units_}});
}

void Session::set_thumbnail(std::string base64) {
    thumbnail_ = std::move(base64);
    if (services_.journal != nullptr)
        services_.journal->write(id_, {entry_of_thumbnail(thumbnail_)});
}

void Session::made_on_purpose() {
    profile_.made_on_purpose();
    keep_profile();
}

void Session::keep_profile() {
    auto entry = profile_.due();
    if (services_.journal != nullptr && entry)
        services_.journal->write(id_, {std::move(*entry)});
}

void Session::dataset_changed(const std::string& dataset) {
    const bool replaced = builds_.dataset_changed(dataset);
    const auto& surfaces = records_.all<protocol::SurfaceRecord>();
    const bool used = std::any_of(surfaces.begin(), surfaces.end(),
                                  [&](const auto& each) { return each.second.dataset == dataset; });
    if (used)
        note_data(dataset, replaced);
}

/// @param replaced  it is known that the values are others than before
void Session::note_data(const std::string& dataset, bool replaced) {
    const auto open = services_.datasets.open(dataset);
    if (!open || open->store == nullptr)
        return;
    const std::string known = profile_.data(dataset);
    if (!replaced && !known.empty() && !open->store->contradicts(known))
        return;
    profile_.set_data(dataset, open->store->values());
    if (known.empty())
        return;
    if (participants_.present().empty())
        replaced_data_.insert(open->info.name);
    keep_profile();
    if (thumbnail_.empty())
        return;
    thumbnail_.clear(); // it shows what is there no more
    if (services_.journal != nullptr)
        services_.journal->write(id_, {{"thumbnail", "", std::nullopt}});
}

void Attendance::seen() {
    seen_ = clock_.now();
    if (!look_)
        look_later();
    if (std::exchange(empty_, false))
        events_.back();
}

std::shared_ptr<void> Attendance::stay() {
    seen();
    if (auto held = stay_.lock())
        return held;
    auto held = std::make_shared<int>();
    stay_ = held;
    return held;
}

void Attendance::look_later() {
    look_ = loop_.after(look_every, [this] { look(); });
}

void Attendance::look() {
    if (!stay_.expired() || events_.somebody())
        seen_ = clock_.now();
    if (clock_.now() - seen_ < nobody)
        return look_later();
    look_.reset();
    empty_ = true;
    events_.empty();
}

using core::Error;
using core::fail;

Session::Session(std::string id,
                 std::string name,
                 SessionServices services,
                 std::uint32_t& next_number,
                 std::string copier)
    : id_(std::move(id)), copier_(std::move(copier)), name_(std::move(name)), services_(services),
      participants_(id_, services.loop, services.entropy, services.journal, services.unix_time),
      leases_(services, [this](const std::string& rake) { lease_ended(rake); }),
      builds_(copier_.empty() ? id_ : Budgets::line_of(copier_),
              services,
              records_,
              next_number,
              build_events()),
      clock_(services.loop,
             services.wall(),
             {[this] {
                  time_kept_ = services_.now();
                  announce({clock_.record()});
              },
              [this](bool jumped) { time_moved(jumped); }}),
      profile_(services.unix_time),
      attendance_(services.loop,
                  services.wall(),
                  {[this] { return somebody(); }, [this] { rest(); }, [this] { resume(); }}) {
    if (services.memory != nullptr)
        memory_ = services.memory->open(core::MemoryUse::Records);
}

std::optional<std::vector<Patch>> Session::changes_since(std::uint64_t seq) const {
    auto changes = changes_.since(seq);
    if (changes)
        for (Patch& each : *changes)
            if (std::holds_alternative<protocol::ClockRecord>(each))
                each = clock_.record();
    return changes;
}

core::Result<std::shared_ptr<LiveSurface>> Session::live(const std::string& id) const {
    if (auto live = builds_.find(id))
        return live;
    return no_record({RecordType::Surface, id});
}

core::Result<void> Session::may_put(const RecordKey& key, bool is_new) const {
    if (!is_new)
        return records_.rev(key) != 0 ? core::Result<void>{} : no_record(key);
    const std::size_t most = most_records(key.type);
    if (records_.count(key.type) < most)
        return {};
    return core::over_limit(most,
                            "a session may have at most " + std::to_string(most) + " " +
                                protocol::plural_of(server::name(key.type)),
                            "delete some, or use another session");
}

/// Checks that the record is sound, and that there is room for it.
core::Result<void> Session::may_keep(const Record& record) const {
    if (auto sound = check_record(record); !sound)
        return sound;
    return has_room(records_.bytes(key_of(record)), bytes_of(record));
}

core::Result<void> Session::has_room(std::size_t before, std::size_t after) const {
    if (after <= before)
        return {};
    const std::size_t bytes = records_.bytes() - before + after;
    const RoomOf whose = copier_.empty() ? RoomOf::Session : RoomOf::Copies;
    const std::size_t beside = copier_.empty() || !services_.records_of_copies
                                   ? 0
                                   : services_.records_of_copies(copier_) - records_.bytes();
    if (auto room = room_in_session(bytes + beside, whose); !room)
        return room;
    return room_beside_others(services_.memory, bytes, after - before, whose);
}

void Session::count_memory() {
    memory_.set(taken_by_records(records_.bytes()) + history_.bytes());
}

RecordChange Session::change_to(Record after) const {
    const RecordKey key = key_of(after);
    const auto before = records_.find(key);
    set_rev(after, (before ? rev_of(*before) : 0) + 1);
    return {key, before, std::make_shared<const Record>(std::move(after))};
}

core::Result<core::ClippedRake> Session::clip_to(const core::Rake& shape,
                                                 const std::string& dataset) const {
    const auto open = services_.datasets.open(dataset);
    if (!open)
        return core::ClippedRake{shape, false};
    return core::clip_rake(shape, open->flow->domain());
}

// A rake in use must lie in the domains of its surfaces' datasets; a free one in any domain, whole if
// possible.
core::Result<core::ClippedRake> Session::clip(const protocol::RakeSetting& setting) const {
    if (auto sound = core::check_rake(setting.shape); !sound) // also where no dataset is open
        return tl::unexpected(sound.error());
    std::vector<std::string> used;
    if (setting.rake)
        for (const std::string& id : records_.hanging_on(*setting.rake))
            used.push_back(records_.find<protocol::SurfaceRecord>(id)->dataset);
    core::ClippedRake result{setting.shape, false};
    for (const std::string& dataset : used) {
        auto clipped = clip_to(result.rake, dataset);
        if (!clipped)
            return clipped;
        result = {clipped->rake, result.clipped || clipped->clipped};
    }
    if (!used.empty())
        return result;
    std::vector<core::Result<core::ClippedRake>> tries;
    for (const std::string& dataset : services_.datasets.ids())
        tries.push_back(clip_to(setting.shape, dataset));
    if (tries.empty())
        return result;
    const auto whole = [](const auto& each) { return each && !each->clipped; };
    const auto partly = [](const auto& each) { return each.has_value(); };
    auto best = std::find_if(tries.begin(), tries.end(), whole);
    if (best == tries.end())
        best = std::find_if(tries.begin(), tries.end(), partly);
    return best == tries.end() ? tries.front() : *best;
}

/// Checks that a page may put a default scene there: the session has not been edited yet.
core::Result<void> Session::may_be_default(RecordType type, bool is_new) const {
    const bool first = type == RecordType::Rake ? records_.empty() : records_.count(type) == 0;
    if (is_new && first && !profile().edited)
        return {};
    return fail(Error::Code::InvalidArgument,
                "`default` is for the first " + std::string(server::name(type)) +
                    " of a session that no one has edited",
                "look at what is there, or leave `default` out");
}

core::Result<RakeChange> Session::set_rake(const protocol::RakeSetting& setting,
                                           const Author& author) {
    if (author.default_scene)
        if (auto may = may_be_default(RecordType::Rake, !setting.rake); !may)
            return tl::unexpected(may.error());
    const RecordKey asked{RecordType::Rake, setting.rake.value_or("")};
    if (auto may = may_put(asked, !setting.rake); !may)
        return tl::unexpected(may.error());
    auto clipped = clip(setting);
    if (!clipped)
        return tl::unexpected(clipped.error());
    protocol::RakeRecord record;
    if (setting.rake) {
        record = *records_.find<protocol::RakeRecord>(*setting.rake);
    } else {
        record.rake = records_.new_id(RecordType::Rake);
        record.author = author.name;
        record.colour = records_.free_colour();
    }
    record.colour = setting.colour.value_or(record.colour);
    record.shape = std::move(clipped->rake);
    record.shape.arc =
        core::Rake{}.arc; // a circle is kept whole: each of its surfaces has its own part of it
    record.clipped = clipped->clipped;
    if (const auto name = core::display_name(setting.name, limits::name_bytes);
        !name.empty() || record.name.empty())
        record.name = name.empty() ? record.rake : name;
    if (auto sound = may_keep(record); !sound)
        return tl::unexpected(sound.error());

    const std::uint64_t drag = settle_lease(record, setting.dragging, author);
    auto surfaces = edit({change_to(record)}, author, drag);
    return RakeChange{*records_.find<protocol::RakeRecord>(record.rake), std::move(surfaces)};
}

// An edit over another participant's lease ends it.
std::uint64_t Session::settle_lease(protocol::RakeRecord& record,
                                    std::optional<bool> dragging,
                                    const Author& author) {
    if (leases_.drag(record.rake, author) == 0)
        leases_.end(record.rake);
    if (dragging == true)
        leases_.take(record.rake, author);
    const std::uint64_t drag = leases_.drag(record.rake, author);
    if (dragging == false)
        leases_.end(record.rake);
    record.dragging = leases_.drag(record.rake, author) != 0;
    record.leased_by = record.dragging ? author.participant : "";
    return drag;
}

std::vector<RecordChange> Session::deletion(const RecordKey& key) const {
    std::vector<RecordChange> changes;
    if (key.type == RecordType::Rake)
        for (const std::string& id : records_.hanging_on(key.id)) {
            const RecordKey surface{RecordType::Surface, id};
            changes.push_back({surface, records_.find(surface), nullptr});
        }
    changes.push_back({key, records_.find(key), nullptr});
    return changes;
}

core::Result<void> Session::remove(const RecordKey& key, const Author& author) {
    if (records_.rev(key) == 0)
        return no_record(key);
    edit(deletion(key), author);
    return {};
}

core::Result<protocol::SurfaceRecord> Session::set_surface(const protocol::SurfaceSetting& asked,
                                                           const Author& author) {
    if (author.default_scene)
        if (auto may = may_be_default(RecordType::Surface, !asked.surface); !may)
            return tl::unexpected(may.error());
    const RecordKey key{RecordType::Surface, asked.surface.value_or("")};
    if (asked.surface && records_.rev(key) == 0)
        return no_record(key);
    const auto own_rake = rake_kept(asked.parameters, asked.rake);
    for (const auto& rake : {own_rake, asked.rake2})
        if (rake && records_.find<protocol::RakeRecord>(*rake) == nullptr)
            return no_record({RecordType::Rake, *rake});
    if (auto may = may_put(key, !asked.surface); !may)
        return tl::unexpected(may.error());
    if (auto sound = protocol::check_rules(asked); !sound)
        return tl::unexpected(sound.error());
    const auto open = services_.datasets.open(asked.dataset);
    if (!open)
        return tl::unexpected(open.error());
    if (asked.twin && asked.twin->dataset)
        if (auto other = services_.datasets.open(*asked.twin->dataset);
            !other && other.error().code == core::Error::Code::NotFound)
            return tl::unexpected(other.error());
    auto fields = fields_once(*open, asked.fields);
    if (!fields)
        return tl::unexpected(fields.error());
    protocol::SurfaceRecord record{{},
                                   0,
                                   0,
                                   own_rake,
                                   asked.rake2,
                                   asked.dataset,
                                   asked.parameters,
                                   asked.twin,
                                   std::move(*fields)};
    auto job = builds_.job_for(record);
    if (!job)
        return tl::unexpected(job.error());
    // What was left to the data, and to the times.
    record.parameters.separation = job->plan.parameters.separation;
    record.parameters.direction = job->plan.parameters.direction;
    record.parameters.from = job->plan.parameters.from;
    record.parameters.to = job->plan.parameters.to;

    record.surface = asked.surface ? *asked.surface : records_.new_id(RecordType::Surface);
    if (auto sound = may_keep(record); !sound)
        return tl::unexpected(sound.error());
    edit({change_to(record)}, author, 0, std::move(*job));
    return *records_.find<protocol::SurfaceRecord>(record.surface);
}

core::Result<protocol::BookmarkRecord>
Session::set_bookmark(const protocol::BookmarkSetting& setting, const Author& author) {
    const RecordKey asked{RecordType::Bookmark, setting.bookmark.value_or("")};
    if (auto may = may_put(asked, !setting.bookmark); !may)
        return tl::unexpected(may.error());
    protocol::BookmarkRecord record;
    if (setting.bookmark)
        record = *records_.find<protocol::BookmarkRecord>(*setting.bookmark);
    else
        record.bookmark = records_.new_id(RecordType::Bookmark);
    if (const auto name = core::display_name(setting.name, limits::name_bytes);
        !name.empty() || record.name.empty())
        record.name = name.empty() ? record.bookmark : name;
    record.view = setting.view;
    record.time = setting.time;
    if (auto sound = may_keep(record); !sound)
        return tl::unexpected(sound.error());
    edit({change_to(record)}, author);
    return *records_.find<protocol::BookmarkRecord>(record.bookmark);
}

core::Result<protocol::AnnotationRecord>
Session::set_annotation(const protocol::AnnotationSetting& setting, const Author& author) {
    const RecordKey asked{RecordType::Annotation, setting.annotation.value_or("")};
    if (auto may = may_put(asked, !setting.annotation); !may)
        return tl::unexpected(may.error());
    protocol::AnnotationRecord record;
    if (setting.annotation)
        record = *records_.find<protocol::AnnotationRecord>(*setting.annotation);
    // The surface may go and the annotation stay, so only a new choice has to be there.
    if (setting.surface && setting.surface != record.surface &&
        records_.find<protocol::SurfaceRecord>(*setting.surface) == nullptr)
        return no_record({RecordType::Surface, *setting.surface});
    if (!setting.annotation) {
        record.annotation = records_.new_id(RecordType::Annotation);
        record.author = author.name;
    }
    record.text = core::display_lines(setting.text, setting.text.size());
    record.position = setting.position;
    record.surface = setting.surface;
    if (auto sound = may_keep(record); !sound)
        return tl::unexpected(sound.error());
    edit({change_to(record)}, author);
    return *records_.find<protocol::AnnotationRecord>(record.annotation);
}

} // namespace wakesurf::server
