#include "core/base/work_memory.hpp"
#include "core/field/analytic_flow.hpp"
#include "core/surface/playback/surface_at.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <optional>

namespace wakesurf::core::memory_refusal_test {

namespace {

constexpr std::size_t little = 64 << 10;

SurfacePlan large(SurfaceKind kind, Refine refine = Refine::On) {
    SurfaceParameters p{.kind = kind, .to = 4.0, .separation = 0.03, .refine = refine};
    if (kind == SurfaceKind::Time)
        p.sweep = Vec3{3, 0, 0};
    const std::shared_ptr<const Flow> flow = make_analytic_flow("abc").value();
    return plan_surface(flow, {Rake::Kind::Line, {{-2, -1, 0.2}, {-2, 1, 3}}, 200}, p).value();
}

} // namespace

/// The reason is the engine's own: no caller has to put it right.
TEST(MemoryRefusal, IsNeverACancellationWhateverIsBuilt) {
    const MemoryAccount account(little);
    for (const SurfaceKind kind :
         {SurfaceKind::Stream, SurfaceKind::Path, SurfaceKind::Streak, SurfaceKind::Time})
        for (const Refine refine : {Refine::On, Refine::Off})
            for (const std::optional<double> time : {std::optional<double>(), std::optional(3.0)}) {
                WorkMemory memory(account, {}, std::chrono::milliseconds(0));
                const auto surface =
                    surface_at(large(kind, refine), time, SteadyClock{}, {}, {nullptr, &memory});
                ASSERT_FALSE(surface) << static_cast<int>(kind);
                EXPECT_EQ(surface.error().code, Error::Code::OverLimit) << surface.error().message;
                EXPECT_NE(surface.error().message.find("of memory"), std::string::npos)
                    << surface.error().message;
            }
}

TEST(MemoryRefusal, IsNotWhatAStoppedBuildSays) {
    const MemoryAccount account(little);
    std::stop_source stop;
    stop.request_stop();
    for (const SurfaceKind kind : {SurfaceKind::Stream, SurfaceKind::Time}) {
        WorkMemory memory(account, stop.get_token());
        const auto surface =
            surface_at(large(kind), {}, SteadyClock{}, stop.get_token(), {nullptr, &memory});
        ASSERT_FALSE(surface);
        EXPECT_EQ(surface.error().code, Error::Code::Cancelled) << surface.error().message;
    }
}

} // namespace wakesurf::core::memory_refusal_test
