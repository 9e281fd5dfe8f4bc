#include "server/session/surface_job.hpp"

#include "core/surface/surface_builder.hpp"
#include "protocol/mesh_encoder.hpp"
#include "server/session/log_text.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace wakesurf::server {

namespace {

using Clock = std::chrono::steady_clock;

struct Pass {
    core::Rake rake;
    core::SurfaceParameters parameters;
    std::uint32_t first_seq = 0;
    bool final = true;
};

/// The engine's quad budget bounds the work whatever the separation asked for.
Pass coarse_pass(const SurfaceJob& job) {
    Pass pass{job.rake, job.parameters, 0, false};
    const auto columns =
        static_cast<std::uint32_t>(std::sqrt(static_cast<double>(job.coarse_quads)));
    pass.rake.seeds = std::min(job.rake.seeds, columns);
    pass.parameters.max_quads = std::min(job.parameters.max_quads, job.coarse_quads);
    pass.parameters.separation *= 2.0;
    pass.parameters.accuracy = core::Accuracy::Fast;
    return pass;
}

core::Result<SurfaceState>
run_pass(const SurfaceJob& job, const Pass& pass, const std::stop_token& stop) {
    const auto start = Clock::now();
    const auto surface = core::build_surface(*job.flow, pass.rake, pass.parameters, stop);
    if (!surface)
        return tl::unexpected(surface.error());
    if (stop.stop_requested())
        return core::fail(core::Error::Code::Cancelled, "a newer edit replaced this surface");
    protocol::EncodeOptions options;
    options.surface = job.number;
    options.epoch = job.epoch;
    options.seq = pass.first_seq;
    options.final = pass.final;
    auto encoded = protocol::encode_state(surface->mesh, job.lattice, options);
    if (!encoded)
        return tl::unexpected(encoded.error());
    SurfaceState state;
    state.epoch = job.epoch;
    state.final = pass.final;
    state.frames = std::move(encoded->frames);
    state.crc = encoded->state_crc;
    state.statistics = surface->statistics;
    state.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return state;
}

/// What libraries throw ends this surface only, not the server.
core::Result<SurfaceState>
guarded_pass(const SurfaceJob& job, const Pass& pass, const std::stop_token& stop) noexcept {
    try {
        return run_pass(job, pass, stop);
    } catch (const std::bad_alloc&) {
        return core::fail(core::Error::Code::OverLimit,
                          "there is not enough memory for this surface",
                          "use a larger separation, fewer seeds or a lower maxQuads");
    } catch (const std::exception& error) {
        spdlog::error("building surface {} failed: {}", job.number, without_paths(error.what()));
        return core::fail(core::Error::Code::Io, "building the surface failed inside the server",
                          "the server's log has the details");
    }
}

} // namespace

double
run_surface_job(const SurfaceJob& job, const std::stop_token& stop, const PublishState& publish) {
    Pass last{job.rake, job.parameters, 0, true};
    if (job.coarse_quads > 0 && !stop.stop_requested()) {
        const auto start = Clock::now();
        auto coarse = guarded_pass(job, coarse_pass(job), stop);
        if (stop.stop_requested())
            return std::chrono::duration<double>(Clock::now() - start).count();
        if (coarse) { // the final pass reports what is wrong for both
            last.first_seq = 1;
            publish(std::move(coarse));
        }
    }
    if (stop.stop_requested())
        return 0.0;
    auto state = guarded_pass(job, last, stop);
    if (!stop.stop_requested())
        publish(std::move(state));
    return 0.0;
}

} // namespace wakesurf::server
