#include "tests/simulation/simulation.hpp"

#include "core/field/analytic_flow.hpp"
#include "tests/simulation/participant.hpp"
#include "tests/simulation/world_server.hpp"
#include "tests/support/same_state.hpp"

#include <oneapi/tbb/task_arena.h>

#include <array>
#include <exception>
#include <memory>
#include <vector>

namespace wakesurf::simulation {

using nlohmann::json;
using namespace std::chrono_literals;

namespace {

constexpr std::size_t people_count = 8;
constexpr auto longest_settling = 60s;

/// The dataset `flow`.
class OneFlow final : public server::Datasets {
  public:
    explicit OneFlow(const std::string& flow)
        : info_(*core::describe_analytic_flow(flow)), flow_(*core::make_analytic_flow(flow)) {}

    std::vector<std::string> ids() const override { return {"flow"}; }

    core::Result<server::OpenDataset> open(const std::string& id) const override {
        if (id != "flow")
            return core::fail(core::Error::Code::NotFound, "no dataset " + id);
        return server::OpenDataset{info_, protocol::lattice_over(info_.bounds), flow_};
    }

  private:
    core::DatasetInfo info_;
    std::shared_ptr<const core::Flow> flow_;
};

std::string flow_of(World& world) {
    static constexpr std::array flows{"uniform", "rotation", "oscillating"};
    return flows[world.pick(flows.size())];
}

class Simulation {
  public:
    explicit Simulation(std::uint64_t seed) : world_(seed), flow_(flow_of(world_)) {}

    Story run() {
        start_server();
        for (std::size_t i = 0; i < people_count; ++i) {
            people_.push_back(std::make_unique<Participant>(world_, "person " + std::to_string(i),
                                                            [this] { return dial(); }));
            people_.back()->connect();
            people_.back()->start_editing(60ms);
        }
        for (std::size_t crashes = 1 + world_.pick(2); crashes > 0; --crashes) {
            live(world_.time_between(100ms, 700ms));
            crash();
            live(world_.time_between(10ms, 300ms));
            start_server();
        }
        live(world_.time_between(100ms, 700ms));
        settle();
        server_.reset();
        story_.digest = world_.digest();
        return story_;
    }

  private:
    void start_server() {
        server_ = std::make_unique<WorldServer>(world_, disk_, flow_);
        check_durable("after a restart");
    }

    void crash() {
        ++story_.crashes;
        server_.reset();
    }

    std::shared_ptr<Link> dial() {
        if (!server_)
            return nullptr;
        const Duration slowest = std::array<Duration, 3>{1ms, 15ms, 80ms}[world_.pick(3)];
        auto link = std::make_shared<Link>(world_, slowest);
        server_->welcome(link);
        return link;
    }

    /// Somewhere meanwhile the disk may be full.
    void live(Duration time) {
        const Duration first = world_.time_between(0ms, time);
        world_.run_for(first);
        if (world_.chance(0.3))
            disk_.full_until = world_.now() + world_.time_between(10ms, 200ms);
        world_.run_for(time - first);
    }

    void settle() {
        for (const auto& each : people_)
            each->stop_editing();
        disk_.full_until = {};
        world_.run_for(500ms);
        server_->session().clock().pause();
        const Instant end = world_.now() + longest_settling;
        std::string difference;
        do {
            world_.run_for(6s); // leases last 5 s
            difference = compare();
        } while (!difference.empty() && world_.now() < end);
        wrong(difference);
        check_durable("at the end");
        for (const auto& each : people_) {
            wrong(each->trouble());
            story_.edits += each->edits();
            story_.losses += each->losses();
            story_.resumed += each->resumed();
            story_.deltas += each->deltas();
            story_.durable += each->acknowledged().size();
        }
    }

    /// What people were told is durable.
    void check_durable(const std::string& when) {
        for (const auto& person : people_)
            for (const Acknowledged& each : person->acknowledged()) {
                if (disk_.deleted.contains({each.type, each.id}))
                    continue;
                for (const server::RecordType type : server::record_types)
                    if (server::name(type) == each.type &&
                        server_->session().records().rev({type, each.id}) < each.rev)
                        wrong(when + ": " + each.type + " " + each.id + " is not at revision " +
                              std::to_string(each.rev) + ", acknowledged as durable");
            }
    }

    /// How what somebody sees differs from what the server has.
    std::string compare() {
        const Participant::Records records =
            records_of(server_->ask("session.state", {{"session", "main"}}));
        story_.records = records.size();
        for (const auto& person : people_) {
            if (!person->connected())
                return person->name() + " is not there";
            if (person->records() != records)
                return person->name() + " has other records: " + json(person->records()).dump() +
                       " and not " + json(records).dump();
        }
        story_.surfaces = 0;
        for (const auto& [key, record] : records)
            if (key.first == "surface")
                if (auto difference = compare_surface(key.second); !difference.empty())
                    return difference;
        return {};
    }

    std::string compare_surface(const std::string& id) {
        const auto live = *server_->session().live(id);
        const server::SurfaceOutcome outcome = live->outcome();
        if (outcome.error)
            return {};
        if (!outcome.complete)
            return "surface " + id + " is not complete";
        const server::SharedUpdate newest = live->newest();
        ++story_.surfaces;
        world_.note(outcome.state_sum);
        // Of a key the server keeps the frames alone; what is left of the state is its sum.
        std::shared_ptr<const protocol::WireMesh> truth = live->ring()->state();
        for (const auto& person : people_) {
            const protocol::DecodedState* const state = person->state(id);
            if (state == nullptr)
                return person->name() + " sees nothing of surface " + id;
            if (state->header.epoch != newest->wire.epoch || state->header.seq != newest->wire.seq)
                return person->name() + " sees an old surface " + id;
            if (!truth)
                truth = state->mesh;
            if (state->header.state_sum != outcome.state_sum ||
                protocol::state_sum(*state->mesh) != outcome.state_sum ||
                !tests::same_state(*state->mesh, *truth))
                return person->name() + " sees another surface " + id;
        }
        return {};
    }

    void wrong(const std::string& what) {
        if (story_.trouble.empty())
            story_.trouble = what;
    }

    World world_;
    OneFlow flow_;
    Disk disk_;
    std::vector<std::unique_ptr<Participant>> people_;
    std::unique_ptr<WorldServer> server_;
    Story story_;
};

} // namespace

Story simulate(std::uint64_t seed) {
    Story story;
    oneapi::tbb::task_arena alone(1); // worlds run side by side, not within each other
    alone.execute([&] {
        try {
            story = Simulation(seed).run();
        } catch (const std::exception& error) {
            story.trouble = std::string("thrown: ") + error.what();
        }
    });
    return story;
}

} // namespace wakesurf::simulation
