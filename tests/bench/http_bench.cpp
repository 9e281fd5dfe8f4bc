// A store of bricks on a web server that is far away: how long the first coarse surface takes. The server is one of ours in this process,
// which waits before it answers each request; libcurl and all above it are the product's.
#include "core/dataset/brick_cache.hpp"
#include "core/surface/builder/surface_builder.hpp"
#include "server/data/open_dataset.hpp"
#include "tests/bench/benchmarks.hpp"
#include "tests/bench/support/temporary_store.hpp"
#include "tests/support/server/scripted_web_server.hpp"

#include <benchmark/benchmark.h>

#include <atomic>
#include <chrono>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>

namespace wakesurf::bench {

namespace http_bench {

using Clock = std::chrono::steady_clock;
using tests::ScriptedWebServer;

constexpr std::chrono::milliseconds to_the_first_byte{100};
constexpr double target_first_coarse_ms = 1500;
constexpr std::uint32_t side = 257;
constexpr std::uint64_t coarse_quads = 1000; // of PassBudgets' first pass

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// A folder, far away.
class FarFolder {
  public:
    explicit FarFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

    std::string address() const { return server_.address("store"); }

    std::uint64_t requests() const { return requests_; }

    std::uint64_t bytes() const { return bytes_; }

  private:
    ScriptedWebServer::Reply answer(const std::string& header) {
        std::this_thread::sleep_for(to_the_first_byte);
        ++requests_;
        const auto slash = header.find("/store/") + 7;
        const std::string name = header.substr(slash, header.find(' ', slash) - slash);
        std::ifstream file(folder_ / name, std::ios::binary | std::ios::ate);
        if (!file)
            return {"HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n"};
        const auto size = static_cast<std::uint64_t>(file.tellg());
        const std::string mark = "ETag: \"1\"\r\nContent-Length: ";
        const auto range = header.find("Range: bytes=");
        if (range == std::string::npos) // only HEAD asks so
            return {"HTTP/1.1 200 OK\r\n" + mark + std::to_string(size) + "\r\n\r\n"};
        const auto dash = header.find('-', range);
        const std::uint64_t first = std::stoull(header.substr(range + 13));
        const std::uint64_t end =
            std::min<std::uint64_t>(size, std::stoull(header.substr(dash + 1)) + 1);
        std::string out = "HTTP/1.1 206 Partial Content\r\n" + mark + std::to_string(end - first) +
                          "\r\nContent-Range: bytes " + std::to_string(first) + "-" +
                          std::to_string(end - 1) + "/" + std::to_string(size) + "\r\n\r\n";
        const std::size_t body = out.size();
        out.resize(body + end - first);
        file.seekg(static_cast<std::streamoff>(first));
        file.read(out.data() + body, static_cast<std::streamsize>(end - first));
        bytes_ += end - first;
        return {std::move(out)};
    }

    std::filesystem::path folder_;
    std::atomic<std::uint64_t> requests_ = 0, bytes_ = 0;
    ScriptedWebServer server_{[this](const std::string& header) { return answer(header); }};
};

void measure(benchmark::State& state, core::SurfaceKind kind) {
    static const TemporaryStore store(
        {"tornado",
         {core::Vec3(0.0), core::Vec3(1.0 / (side - 1)), {side, side, side}},
         {0.0, 0.25, 0.5},
         store::StepPlacement::Bricks});
    for (auto _ : state) {
        const FarFolder far(store.folder());
        const auto start = Clock::now();
        const auto dataset = server::open_store(far.address(), {});
        if (!dataset)
            throw std::runtime_error(dataset.error().message);
        const double opened = milliseconds_since(start);
        const std::uint64_t requests = far.requests();
        core::SurfaceParameters parameters;
        parameters.kind = kind;
        parameters.to = 0.5;
        parameters.separation = 0.01;
        parameters.max_quads = coarse_quads;
        const core::Rake rake{core::Rake::Kind::Line, {{0.4, 0.5, 0.1}, {0.6, 0.5, 0.8}}, 16};
        const auto began = Clock::now();
        const auto surface = core::build_surface(*dataset->flow, rake, parameters);
        if (!surface)
            throw std::runtime_error(surface.error().message);
        const double took = milliseconds_since(began);
        state.SetIterationTime(1e-3 * took);
        state.counters["target_ms"] = target_first_coarse_ms;
        state.counters["open_ms"] = opened;
        state.counters["quads"] = static_cast<double>(surface->mesh.cells.size());
        state.counters["rounds"] = static_cast<double>(dataset->cache->bricks()->status().rounds);
        state.counters["requests"] = static_cast<double>(far.requests() - requests);
        state.counters["megabytes"] = 1e-6 * static_cast<double>(far.bytes());
    }
}

} // namespace http_bench

void register_http_benchmarks() {
    const auto run = [](const char* name, core::SurfaceKind kind) {
        benchmark::RegisterBenchmark(
            name, [kind](benchmark::State& state) { http_bench::measure(state, kind); })
            ->Unit(benchmark::kMillisecond)
            ->UseManualTime()
            ->Iterations(1);
    };
    run("bricks/http/stream", core::SurfaceKind::Stream);
    run("bricks/http/streak", core::SurfaceKind::Streak);
}

} // namespace wakesurf::bench
