#include "server/session/session.hpp"

#include "core/surface/surface_request.hpp"
#include "server/limits.hpp"
#include "server/session/surface_rules.hpp"

#include <algorithm>
#include <utility>

namespace wakesurf::server {

using core::Error;
using core::fail;

namespace {

tl::unexpected<Error> no_record(const char* type, const std::string& id) {
    const std::string list = std::string(type) + ".list";
    return fail(Error::Code::NotFound,
                std::string("there is no ") + type + " `" + id.substr(0, 64) + "`",
                "list them with " + list);
}

tl::unexpected<Error> too_many(const char* what, std::size_t limit) {
    return fail(Error::Code::OverLimit,
                "a session may have at most " + std::to_string(limit) + " " + what,
                "delete some, or use another session");
}

} // namespace

Session::Session(std::string id,
                 std::string name,
                 SessionServices services,
                 std::uint32_t& next_number)
    : id_(std::move(id)), name_(std::move(name)), services_(services), next_number_(next_number),
      participants_(services.entropy) {}

Session::~Session() {
    *alive_ = false;
    for (const auto& [id, entry] : surfaces_)
        entry.live->retire();
}

std::vector<protocol::RakeRecord> Session::rakes() const {
    std::vector<protocol::RakeRecord> out;
    for (const auto& [id, record] : rakes_)
        out.push_back(record);
    return out;
}

std::vector<protocol::SurfaceRecord> Session::surfaces() const {
    std::vector<protocol::SurfaceRecord> out;
    for (const auto& [id, entry] : surfaces_)
        out.push_back(entry.record);
    return out;
}

core::Result<protocol::RakeRecord> Session::rake(const std::string& id) const {
    const auto found = rakes_.find(id);
    if (found == rakes_.end())
        return no_record("rake", id);
    return found->second;
}

core::Result<protocol::SurfaceRecord> Session::surface(const std::string& id) const {
    const auto found = surfaces_.find(id);
    if (found == surfaces_.end())
        return no_record("surface", id);
    return found->second.record;
}

core::Result<std::shared_ptr<LiveSurface>> Session::live(const std::string& id) const {
    const auto found = surfaces_.find(id);
    if (found == surfaces_.end())
        return no_record("surface", id);
    return found->second.live;
}

core::Result<core::ClippedRake> Session::clip_to(const core::Rake& shape,
                                                 const std::string& dataset) const {
    return services_.datasets.open(dataset).and_then(
        [&](const OpenDataset& open) { return core::clip_rake(shape, open.flow->domain()); });
}

/// A rake belongs to no dataset. It must lie in those its surfaces are built from, or, while it has none, in at least
/// one of the catalogue's.
core::Result<core::ClippedRake> Session::clip(const protocol::RakeSetting& setting) const {
    std::vector<std::string> used;
    for (const auto& [id, entry] : surfaces_)
        if (setting.rake && entry.record.hangs_on(*setting.rake))
            used.push_back(entry.record.dataset);
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

core::Result<RakeChange> Session::set_rake(const protocol::RakeSetting& setting) {
    if (setting.rake && !rakes_.contains(*setting.rake))
        return no_record("rake", *setting.rake);
    if (!setting.rake && rakes_.size() >= limits::rakes)
        return too_many("rakes", limits::rakes);
    auto clipped = clip(setting);
    if (!clipped)
        return tl::unexpected(clipped.error());
    const std::string id = setting.rake ? *setting.rake : "r" + std::to_string(next_rake_++);
    protocol::RakeRecord& record = rakes_[id];
    record.rake = id;
    ++record.rev;
    record.shape = std::move(clipped->rake);
    record.clipped = clipped->clipped;
    record.dragging = setting.dragging;
    if (!setting.name.empty() || record.name.empty())
        record.name = setting.name.empty() ? id : setting.name;

    RakeChange change{record, {}};
    std::vector<Patch> patches{record};
    for (auto& [surface, entry] : surfaces_) {
        if (!entry.record.hangs_on(id))
            continue;
        auto job = job_for(entry.record);
        if (!job) // its dataset has gone since; the surface keeps what it has
            continue;
        entry.record.epoch = entry.live->rebuild(std::move(*job));
        change.surfaces.emplace_back(surface, entry.record.epoch);
        patches.emplace_back(entry.record);
    }
    announce(patches);
    return change;
}

core::Result<void> Session::delete_rake(const std::string& id) {
    if (!rakes_.contains(id))
        return no_record("rake", id);
    std::vector<Patch> patches;
    std::erase_if(surfaces_, [&](auto& each) {
        auto& [surface, entry] = each;
        if (!entry.record.hangs_on(id))
            return false;
        entry.live->retire();
        patches.emplace_back(DeletedRecord{"surface", surface});
        return true;
    });
    rakes_.erase(id);
    patches.emplace_back(DeletedRecord{"rake", id});
    announce(patches);
    return {};
}

core::Result<SurfaceJob> Session::job_for(const protocol::SurfaceRecord& record) const {
    auto open = services_.datasets.open(record.dataset);
    if (!open)
        return tl::unexpected(open.error());
    auto rake = core::clip_rake(rakes_.at(record.rake).shape, open->flow->domain());
    if (!rake)
        return tl::unexpected(rake.error());
    core::SurfaceParameters p = record.parameters;
    if (record.rake2) {
        auto second = core::clip_rake(rakes_.at(*record.rake2).shape, open->flow->domain());
        if (!second)
            return tl::unexpected(second.error());
        p.rake2 = std::move(second->rake);
    }
    if (auto sound = core::check_request(p); !sound)
        return tl::unexpected(sound.error());
    // The engine's own checks of times and budget, now rather than when the job runs.
    if (auto options = core::sheet_options(*open->flow, rake->rake, p, p.separation, 1.0); !options)
        return tl::unexpected(options.error());
    SurfaceJob job;
    job.rake = std::move(rake->rake);
    job.parameters = std::move(p);
    job.flow = open->flow;
    job.lattice = open->lattice;
    return job;
}

core::Result<protocol::SurfaceRecord> Session::set_surface(const protocol::SurfaceSetting& asked) {
    if (asked.surface && !surfaces_.contains(*asked.surface))
        return no_record("surface", *asked.surface);
    if (!rakes_.contains(asked.rake))
        return no_record("rake", asked.rake);
    if (asked.rake2 && !rakes_.contains(*asked.rake2))
        return no_record("rake", *asked.rake2);
    if (!asked.surface && surfaces_.size() >= limits::surfaces)
        return too_many("surfaces", limits::surfaces);
    protocol::SurfaceSetting setting = asked;
    const auto open = services_.datasets.open(setting.dataset);
    if (!open)
        return tl::unexpected(open.error());
    if (auto complete = complete_surface(setting, *open); !complete)
        return tl::unexpected(complete.error());
    protocol::SurfaceRecord record{
        {}, 0, 0, setting.rake, setting.rake2, setting.dataset, setting.parameters, setting.fields};
    auto job = job_for(record);
    if (!job)
        return tl::unexpected(job.error());

    record.surface = setting.surface ? *setting.surface : "s" + std::to_string(next_surface_++);
    SurfaceEntry& entry = surfaces_[record.surface];
    if (!entry.live)
        entry.live = make_live(record.surface);
    record.rev = entry.record.rev + 1;
    record.epoch = entry.live->rebuild(std::move(*job));
    entry.record = record;
    announce({record});
    return record;
}

std::shared_ptr<LiveSurface> Session::make_live(const std::string& id) {
    LiveSurface::Events events;
    events.progress = [this, id](std::uint32_t epoch, bool final) {
        for (const Participant& each : participants_.present())
            each.observer->progress(id, epoch, final);
    };
    events.done = [this](const SurfaceOutcome& outcome) {
        for (const Participant& each : participants_.present())
            each.observer->done(outcome);
        built(outcome);
    };
    return std::make_shared<LiveSurface>(id, next_number_++, services_.loop, services_.pool,
                                         std::move(events));
}

core::Result<void> Session::delete_surface(const std::string& id) {
    const auto found = surfaces_.find(id);
    if (found == surfaces_.end())
        return no_record("surface", id);
    found->second.live->retire();
    surfaces_.erase(found);
    announce({DeletedRecord{"surface", id}});
    return {};
}

void Session::built(const SurfaceOutcome& outcome) {
    const auto found = surfaces_.find(outcome.surface);
    if (found == surfaces_.end() || !std::exchange(found->second.data_came, false))
        return;
    // Not from within the event: the surface is still telling others of it.
    services_.loop.post(
        [weak = std::weak_ptr(found->second.live), this, alive = alive_, id = outcome.surface] {
            if (!*alive)
                return;
            const auto entry = surfaces_.find(id);
            if (entry != surfaces_.end() && entry->second.live == weak.lock())
                try_again(entry->second);
        });
}

void Session::dataset_changed(const std::string& dataset) {
    for (auto& [id, entry] : surfaces_) {
        if (entry.record.dataset != dataset)
            continue;
        if (entry.live->busy())
            entry.data_came = true;
        else
            try_again(entry);
    }
}

// Where nothing was missing the surface stays what it is.
void Session::try_again(SurfaceEntry& entry) {
    const SurfaceOutcome outcome = entry.live->outcome();
    const auto open = services_.datasets.open(entry.record.dataset);
    if (!open)
        return;
    if (outcome.statistics.stopped.empty() && !outcome.error)
        return entry.live->renew_flow(open->flow);
    auto job = job_for(entry.record);
    if (!job)
        return;
    entry.record.epoch = entry.live->rebuild(std::move(*job));
    announce({entry.record});
}

void Session::announce(const std::vector<Patch>& patches) {
    ++seq_;
    for (const Participant& each : participants_.present())
        each.observer->patched(id_, seq_, patches);
}

} // namespace wakesurf::server
