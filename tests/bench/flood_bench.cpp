// One viewer's link at full force, beside a host who joins, edits a surface in another session and downloads it.
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/edited_surface.hpp"
#include "tests/bench/load/link_flood.hpp"
#include "tests/bench/support/quantiles.hpp"

#include <benchmark/benchmark.h>
#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace wakesurf::bench {

namespace flood_bench {

using nlohmann::json;
using Clock = std::chrono::steady_clock;

constexpr double quads = 2'000;
constexpr int edits = 200;
constexpr int joins = 20;
constexpr int downloads = 20;
constexpr std::chrono::seconds gathering{5}; ///< of the flood, before anything is measured
constexpr double target_join_s = 1.0;
constexpr double target_p99_ms = 50.0;
constexpr double target_ratio = 3.0;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

std::vector<double> edit_often(EditedSurface& surface) {
    std::vector<double> times;
    for (int i = 0; i < edits; ++i) {
        const json before = surface.complete();
        const auto start = Clock::now();
        surface.client().send("rake.set", surface.next_edit());
        surface.until_frame_after(before["epoch"]);
        times.push_back(seconds_since(start));
    }
    return times;
}

/// From the first byte of a connection to the answer with the whole session.
std::vector<double> join_often(const ServerAddress& address, const std::string& session) {
    std::vector<double> times;
    for (int i = 0; i < joins; ++i) {
        const auto start = Clock::now();
        LiveClient client(address);
        client.call("session.join", {{"session", session}, {"name", "host"}});
        times.push_back(seconds_since(start));
    }
    return times;
}

std::string mesh_of(const EditedSurface& surface) {
    return "/api/v1/sessions/" + surface.session() + "/surfaces/" + surface.surface() + "/mesh.vtp";
}

/// How many of some downloads, one after the other, are served.
int download_often(const ServerAddress& address, const std::string& path) {
    namespace asio = boost::asio;
    int served = 0;
    for (int i = 0; i < downloads; ++i) {
        asio::io_context context;
        asio::ip::tcp::socket socket(context);
        asio::ip::tcp::resolver resolver(context);
        asio::connect(socket, resolver.resolve(address.host, address.port));
        asio::write(socket, asio::buffer("GET " + path + " HTTP/1.1\r\nHost: " + address.host +
                                         "\r\nAuthorization: Bearer " + address.token +
                                         "\r\nConnection: close\r\n\r\n"));
        std::string answer;
        boost::system::error_code end;
        asio::read(socket, asio::dynamic_buffer(answer), end);
        served += answer.starts_with("HTTP/1.1 200") ? 1 : 0;
    }
    return served;
}

void measure(benchmark::State& state, const std::string& dataset) {
    const LiveServer server({dataset, "--log-level", "error"});
    EditedSurface light(server.address(), quads, 200);
    EditedSurface watched(server.address(), quads, 200); // in the session the link is for
    ServerAddress by_link = server.address();
    by_link.token = watched.client().call("session.share", {{"role", "viewer"}})["key"];
    for (auto _ : state) {
        const auto alone = edit_often(light);
        const LinkFlood flood(by_link, {.mesh = mesh_of(watched)});
        std::this_thread::sleep_for(gathering);
        const auto joined = join_often(server.address(), light.session());
        const auto beside = edit_often(light);
        const int served = download_often(server.address(), mesh_of(light));
        const FloodCounts counts = flood.counts();
        state.SetIterationTime(quantile(beside, 0.99));
        state.counters["alone_p50_ms"] = 1e3 * quantile(alone, 0.5);
        state.counters["alone_p99_ms"] = 1e3 * quantile(alone, 0.99);
        state.counters["beside_p50_ms"] = 1e3 * quantile(beside, 0.5);
        state.counters["beside_p99_ms"] = 1e3 * quantile(beside, 0.99);
        state.counters["target_p99_ms"] = target_p99_ms;
        state.counters["ratio_p99"] = quantile(beside, 0.99) / quantile(alone, 0.99);
        state.counters["target_ratio_p99"] = target_ratio;
        state.counters["join_worst_s"] = quantile(joined, 1.0);
        state.counters["target_join_s"] = target_join_s;
        state.counters["downloads_served"] = served;
        state.counters["target_downloads_served"] = downloads;
        state.counters["flood_sockets"] = static_cast<double>(counts.let_in);
        state.counters["flood_turned_away"] = static_cast<double>(counts.turned_away);
        state.counters["flood_edits"] = static_cast<double>(counts.edits);
        state.counters["flood_downloads"] = static_cast<double>(counts.downloaded);
        state.counters["flood_downloads_refused"] = static_cast<double>(counts.not_downloaded);
    }
}

} // namespace flood_bench

void register_flood_benchmark(const std::string& dataset) {
    using namespace flood_bench;
    benchmark::RegisterBenchmark("flood/host_beside_one_link",
                                 [dataset](benchmark::State& state) { measure(state, dataset); })
        ->Unit(benchmark::kMillisecond)
        ->UseManualTime()
        ->Iterations(1);
}

} // namespace wakesurf::bench
