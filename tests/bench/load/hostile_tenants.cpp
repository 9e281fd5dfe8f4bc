#include "tests/bench/load/hostile_tenants.hpp"

#include "core/base/vec3.hpp"
#include "server/live/compute/worker_threads.hpp"
#include "tests/support/server/raw_socket.hpp"

#include <nlohmann/json.hpp>

#include <chrono>
#include <cmath>
#include <stdexcept>

namespace wakesurf::bench {

using nlohmann::json;

namespace {

constexpr int surfaces = 64;      // limits::surfaces
constexpr int quads = 4'000'000;  // limits::quads_most
constexpr double cells = 1'500.0; // along the longest side: more quads than anybody may have
constexpr auto between_edits = std::chrono::milliseconds(100);
constexpr auto before_again = std::chrono::milliseconds(300);

/// What a tenant works on.
struct Domain {
    std::string dataset;
    core::Vec3 low{0.0}, size{0.0};
    double from = 0.0, to = 1.0;
};

Domain domain_of(LiveClient& client, int number) {
    const json list = client.call("dataset.list", json::object())["datasets"];
    Domain out;
    out.dataset = list[static_cast<std::size_t>(number) % list.size()]["dataset"];
    const json info = client.call("dataset.describe", {{"dataset", out.dataset}});
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<std::size_t>(2 * axis);
        out.low[axis] = info["bounds"][i];
        out.size[axis] = info["bounds"][i + 1].get<double>() - out.low[axis];
    }
    out.from = info["times"].front();
    out.to = info["times"].back();
    return out;
}

json rake_of(const Domain& domain, double phase) {
    const auto point = [&](double z) {
        const core::Vec3 p =
            domain.low + domain.size * core::Vec3(0.3, 0.45 + 0.1 * std::sin(phase), z);
        return json{p.x, p.y, p.z};
    };
    return {{"kind", "line"}, {"points", {point(0.05), point(0.95)}}, {"seeds", 400}};
}

json surface_of(const Domain& domain, const std::string& rake, int i) {
    constexpr const char* kinds[]{"stream", "path", "streak", "time"};
    const std::string kind = kinds[i % 4];
    json out{{"rake", rake},
             {"kind", kind},
             {"dataset", domain.dataset},
             {"from", domain.from},
             {"to", kind == "stream" ? domain.from + 50.0 * (domain.to - domain.from) : domain.to},
             {"separation", std::max({domain.size.x, domain.size.y, domain.size.z}) / cells},
             {"maxQuads", quads},
             {"fields", {"vorticity", "q_criterion", "deformation", "approximated"}}};
    if (kind == "time")
        out["sweep"] = {0.2 * domain.size.x, 0.0, 0.0};
    return out;
}

} // namespace

HostileTenants::HostileTenants(const ServerAddress& address, int sessions)
    : address_(address), session_(static_cast<std::size_t>(sessions)) {
    for (int i = 0; i < sessions; ++i) {
        threads_.emplace_back([this, i](const std::stop_token& stop) {
            server::step_back(server::long_niceness);
            edit(stop, i);
        });
        threads_.emplace_back([this, i](const std::stop_token& stop) {
            server::step_back(server::long_niceness);
            download(stop, i);
        });
    }
}

HostileTenants::~HostileTenants() {
    for (std::jthread& each : threads_)
        each.request_stop();
}

void HostileTenants::fill_session(LiveClient& client, const std::string& session, int number) {
    const Domain domain = domain_of(client, number);
    const std::string rake = client.call("rake.set", rake_of(domain, number))["rake"];
    for (int i = 0; i < surfaces; ++i) {
        const std::string id = client.call("surface.set", surface_of(domain, rake, i))["surface"];
        if (i % 4 != 3) // some are no one's
            client.call("surface.subscribe", {{"surface", id}});
        session_[static_cast<std::size_t>(number)] =
            std::stoi(session.substr(session.rfind('-') + 1));
    }
    client.call("time.play", {{"speed", 0.2 * (domain.to - domain.from)}});
}

/// Whatever is refused, and whenever it is sent away, it comes again.
void HostileTenants::edit(const std::stop_token& stop, int number) {
    double phase = number;
    while (!stop.stop_requested()) {
        try {
            LiveClient client(address_);
            const std::string session =
                client.call("session.create", {{"name", "hostile"}})["session"];
            client.call("session.join", {{"session", session}, {"name", "hostile"}});
            fill_session(client, session, number);
            const Domain domain = domain_of(client, number);
            const std::string rake = client.call("rake.list", json::object())["rakes"][0]["rake"];
            // Long enough for large surfaces to come to an end between drags.
            for (int i = 1; !stop.stop_requested(); ++i) {
                if (i % 60 < 20) {
                    json moved = rake_of(domain, phase += 0.05);
                    moved["rake"] = rake;
                    client.call("rake.set", moved);
                    ++edits_;
                } else {
                    client.call("server.ping", json::object());
                }
                std::this_thread::sleep_for(between_edits);
            }
        } catch (const std::exception&) {
            ++refused_;
            std::this_thread::sleep_for(before_again);
        }
    }
}

void HostileTenants::download(const std::stop_token& stop, int number) {
    constexpr const char* files[]{"vtp", "obj", "ply", "glb"};
    const auto port = static_cast<std::uint16_t>(std::stoi(address_.port));
    for (int i = 0; !stop.stop_requested(); ++i) {
        const int session = session_[static_cast<std::size_t>(number)];
        if (session == 0) {
            std::this_thread::sleep_for(before_again);
            continue;
        }
        try {
            const auto reply =
                tests::http(port, "GET",
                            "/api/v1/sessions/session-" + std::to_string(session) + "/surfaces/s" +
                                std::to_string(1 + i % surfaces) + "/mesh." + files[i % 4],
                            {{"Authorization", "Bearer " + address_.token}});
            ++(reply.status == 200 ? downloads_ : refused_);
            if (reply.status != 200)
                std::this_thread::sleep_for(between_edits);
        } catch (const std::exception&) { // it said nothing for too long
            ++refused_;
        }
    }
}

} // namespace wakesurf::bench
