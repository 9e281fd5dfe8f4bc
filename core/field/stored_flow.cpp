#include "core/field/stored_flow.hpp"

#include "core/field/interval_flow.hpp"
#include "core/field/rectilinear_sampling.hpp"
#include "core/field/uniform_sampling.hpp"

#include <stdexcept>
#include <variant>

namespace wakesurf::core {

namespace {

// One overload for every kind of grid that can be sampled.

auto sampling_of(const UniformGrid& grid, const TimeStepSource& source, Simd simd) {
    return std::make_unique<const UniformSampling>(grid, source.mask(), simd);
}

auto sampling_of(const RectilinearGrid& grid, const TimeStepSource& source, Simd) {
    return std::make_unique<const RectilinearSampling>(grid, source.mask());
}

} // namespace

std::unique_ptr<Flow> make_stored_flow(std::shared_ptr<TimeStepCache> cache,
                                       std::shared_ptr<const Clock> clock,
                                       Simd simd) {
    const TimeStepSource& source = cache->source();
    const auto flow_over = [&](const auto& grid) -> std::unique_ptr<Flow> {
        if constexpr (requires { sampling_of(grid, source, simd); }) {
            auto sampling = sampling_of(grid, source, simd);
            using Sampling = std::remove_cv_t<typename decltype(sampling)::element_type>;
            return std::make_unique<IntervalFlow<Sampling>>(cache, std::move(clock),
                                                            std::move(sampling));
        } else {
            throw std::invalid_argument("this kind of grid cannot be sampled");
        }
    };
    return std::visit(flow_over, source.grid());
}

} // namespace wakesurf::core
