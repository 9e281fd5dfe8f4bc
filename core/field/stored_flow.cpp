#include "core/field/stored_flow.hpp"

#include "core/field/cell_sampling.hpp"
#include "core/field/grid_sampling.hpp"
#include "core/field/interval_flow.hpp"
#include "core/field/periodic_sampling.hpp"

#include <variant>

namespace wakesurf::core {

namespace {

// Each kind of grid has an overload.

auto sampling_of(const UniformGrid& grid, const TimeStepSource& source, Simd simd) {
    return std::make_unique<const UniformSampling>(grid, source.mask(), simd);
}

auto sampling_of(const RectilinearGrid& grid, const TimeStepSource& source, Simd simd) {
    return std::make_unique<const RectilinearSampling>(grid, source.mask(), simd);
}

auto sampling_of(const CellMesh& mesh, const TimeStepSource& source, Simd) {
    return std::make_unique<const CellSampling>(mesh, bounds(source.grid()));
}

} // namespace

std::unique_ptr<Flow> make_stored_flow(std::shared_ptr<TimeStepCache> cache,
                                       std::shared_ptr<const Clock> clock,
                                       Simd simd) {
    const TimeStepSource& source = cache->source();
    const auto flow_over = [&](const auto& grid) -> std::unique_ptr<Flow> {
        auto sampling = sampling_of(grid, source, simd);
        using Sampling = std::remove_cv_t<typename decltype(sampling)::element_type>;
        if (any(source.periodic())) {
            using Periodic = PeriodicSampling<Sampling>;
            return std::make_unique<IntervalFlow<Periodic>>(
                cache, std::move(clock),
                std::make_unique<const Periodic>(std::move(sampling), bounds(grid),
                                                 source.periodic()));
        }
        return std::make_unique<IntervalFlow<Sampling>>(cache, std::move(clock),
                                                        std::move(sampling));
    };
    return std::visit(flow_over, source.grid());
}

} // namespace wakesurf::core
