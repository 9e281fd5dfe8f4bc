// A session to edit without sockets: three participants who see every patch, a journal in memory, a flow with
// a closed form.
#pragma once

#include "core/field/analytic_flow.hpp"
#include "server/base/journal.hpp"
#include "server/live/compute/compute_pool.hpp"
#include "server/sessions/session_directory.hpp"
#include "tests/support/server/hand_loop.hpp"

#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace wakesurf::tests {

/// Has the flow `abc`, which can be removed and restored.
class OneFlow final : public server::Datasets {
  public:
    std::vector<std::string> ids() const override {
        return there ? std::vector<std::string>{"abc"} : std::vector<std::string>{};
    }

    core::Result<server::OpenDataset> open(const std::string& id) const override {
        if (id != "abc" || !there)
            return core::fail(core::Error::Code::NotFound, "no dataset " + id);
        auto info = core::describe_analytic_flow("abc");
        return server::OpenDataset{*info, protocol::lattice_over(info->bounds), flow_};
    }

    bool there = true;

  private:
    std::shared_ptr<const core::Flow> flow_ = *core::make_analytic_flow("abc");
};

/// Keeps its entries as a database would.
class MemoryJournal final : public server::Journal {
  public:
    void write(const std::string& session, std::vector<server::JournalEntry> entries) override {
        ++batches;
        if (broken)
            return;
        for (server::JournalEntry& each : entries) {
            auto& kept = sessions[session];
            const std::pair key{each.type, each.id};
            if (each.record)
                kept[key] = std::move(*each.record);
            else
                kept.erase(key);
        }
    }

    void remove(const std::string& session) override { sessions.erase(session); }

    void settled(std::function<void(core::Result<void>)> done) override {
        if (broken)
            done(core::fail(core::Error::Code::Io, "the disk is full"));
        else
            done({});
    }

    std::vector<server::JournalEntry> entries(const std::string& session) const {
        std::vector<server::JournalEntry> out;
        if (const auto found = sessions.find(session); found != sessions.end())
            for (const auto& [key, record] : found->second)
                out.push_back({key.first, key.second, record});
        return out;
    }

    std::map<std::string, std::map<std::pair<std::string, std::string>, std::string>> sessions;
    std::size_t batches = 0;
    bool broken = false;
};

/// Folds patches like a client.
struct Onlooker final : server::Observer {
    void patched(const std::string&,
                 std::uint64_t new_seq,
                 std::span<const server::Patch> patches,
                 server::Telling&) override {
        in_order = in_order && (seq == 0 || new_seq == seq + 1);
        seq = new_seq;
        for (const server::Patch& each : patches)
            std::visit([this](const auto& patch) { fold(patch); }, each);
    }

    void progress(const server::SurfaceProgress&, server::Telling&) override {}

    void done(const server::SurfaceOutcome& outcome, server::Telling&) override {
        outcomes.push_back(outcome);
    }

    void fold(const server::DeletedRecord& gone) {
        for (const server::RecordType type : server::record_types)
            if (server::name(type) == gone.type)
                records.erase({type, gone.id});
    }

    void fold(const protocol::ClockRecord&) {}

    void fold(const server::SessionName& now) { name = now.name; }

    template <class R>
    void fold(const R& record) {
        records.put(server::Record(record));
    }

    server::SessionRecords records;
    std::string name; ///< empty: not renamed since
    std::uint64_t seq = 0;
    bool in_order = true;
    std::vector<server::SurfaceOutcome> outcomes;
};

struct SessionBench {
    /// Advances the wall clock as well, an hour at a time.
    void pass(std::chrono::hours time) {
        for (std::chrono::hours each(0); each < time; ++each) {
            wall += 3600;
            loop.pass(std::chrono::hours(1));
        }
    }

    std::int64_t wall = 1'800'000'000; ///< seconds since 1970
    HandLoop loop;
    server::ComputePool pool{1};
    OneFlow datasets;
    server::SystemEntropy entropy;
    MemoryJournal journal;
    server::SessionDirectory sessions{services()};
    std::shared_ptr<server::Session> session = *sessions.find("main");

    const server::Author ada{"p1", "Ada"};
    const server::Author bob{"p2", "Bob"};
    const server::Author script{"script", "a script"};

  private:
    server::SessionServices services() {
        server::SessionServices out{loop, pool, datasets, entropy};
        out.journal = &journal;
        out.clock = &loop;
        out.unix_time = [this] { return wall; };
        return out;
    }
};

inline protocol::RakeSetting rake_at(double x, std::optional<std::string> id = {}) {
    protocol::RakeSetting setting;
    setting.rake = std::move(id);
    setting.shape.points = {{x, 0, 0}, {x, 2, 0}};
    setting.shape.seeds = 5;
    return setting;
}

inline protocol::RakeSetting
dragged(double x, std::string id, std::optional<bool> dragging = true) {
    auto setting = rake_at(x, std::move(id));
    setting.dragging = dragging;
    return setting;
}

inline protocol::SurfaceSetting surface_on(const std::string& rake,
                                           std::optional<std::string> id = {}) {
    protocol::SurfaceSetting setting;
    setting.surface = std::move(id);
    setting.rake = rake;
    setting.dataset = "abc";
    setting.parameters.to = 0.25;
    return setting;
}

inline protocol::SliceSetting slice_at(double x, std::optional<std::string> id = {}) {
    protocol::SliceSetting setting;
    setting.slice = std::move(id);
    setting.dataset = "abc";
    setting.origin = {x, 1, 1};
    setting.normal = {1, 0.5, 0};
    return setting;
}

inline protocol::LinesSetting lines_from(double x, std::optional<std::string> id = {}) {
    protocol::LinesSetting setting;
    setting.lines = std::move(id);
    setting.dataset = "abc";
    setting.places = {core::LineSeeds::Kind::Line, {{x, 1, 1}, {x, 2, 1}}, 0.0, 5};
    return setting;
}

inline protocol::BookmarkSetting bookmark_of(std::string view, std::optional<std::string> id = {}) {
    protocol::BookmarkSetting setting;
    setting.bookmark = std::move(id);
    setting.view = std::move(view);
    return setting;
}

inline protocol::AnnotationSetting note(std::string text, std::optional<std::string> id = {}) {
    protocol::AnnotationSetting setting;
    setting.annotation = std::move(id);
    setting.text = std::move(text);
    setting.position = {1, 2, 3};
    return setting;
}

/// Returns the records without the parts that restoring and undoing may change.
inline std::vector<server::Record> content(const server::SessionRecords& records,
                                           bool revs = true) {
    std::vector<server::Record> out = records.list();
    for (server::Record& each : out) {
        if (!revs)
            server::set_rev(each, 0);
        if (auto* rake = std::get_if<protocol::RakeRecord>(&each)) {
            rake->dragging = false;
            rake->leased_by.clear();
        }
        if (auto* surface = std::get_if<protocol::SurfaceRecord>(&each))
            surface->epoch = 0;
    }
    return out;
}

} // namespace wakesurf::tests
