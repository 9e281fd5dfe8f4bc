// What the server counts: the text a Prometheus server reads, and the quantiles a client shows.
#include "server/base/metrics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace wakesurf::tests::metrics_test {

using namespace server;

namespace {

class SetClock final : public core::Clock {
  public:
    std::chrono::steady_clock::time_point now() const override { return time; }

    std::chrono::steady_clock::time_point time{};
};

/// Whether the text has `line` as a whole line.
bool has_line(const std::string& text, const std::string& line) {
    return ("\n" + text).find("\n" + line + "\n") != std::string::npos;
}

} // namespace

TEST(RecentValuesTest, GivesTheNearestRankOfASortedTwin) {
    RecentValues values;
    std::mt19937 random(7);
    std::vector<double> all;
    const RecentValues::Time now{};
    for (int i = 0; i < 500; ++i) {
        all.push_back(static_cast<double>(random() % 1000));
        values.add(now, all.back());
    }
    std::sort(all.begin(), all.end());
    const Quantiles got = values.quantiles(now);
    EXPECT_EQ(got.count, 500u);
    EXPECT_EQ(got.p50, all[249]);
    EXPECT_EQ(got.p95, all[474]);
    EXPECT_EQ(got.p99, all[494]);
}

TEST(RecentValuesTest, ForgetsWhatIsOlderThanAMinuteAndAllButTheNewest) {
    RecentValues values;
    RecentValues::Time now{};
    values.add(now, 100.0);
    now += RecentValues::window;
    EXPECT_EQ(values.quantiles(now).count, 1u);
    now += std::chrono::milliseconds(1);
    EXPECT_EQ(values.quantiles(now).count, 0u);
    for (std::size_t i = 0; i < 3 * RecentValues::most; ++i)
        values.add(now, i < 2 * RecentValues::most ? 9.0 : 1.0);
    const Quantiles got = values.quantiles(now);
    EXPECT_EQ(got.count, RecentValues::most);
    EXPECT_EQ(got.p99, 1.0);
}

TEST(MetricsTest, PutsEachStageIntoItsHistogram) {
    const SetClock clock;
    Metrics metrics(clock);
    metrics.observe(Stage::Queue, 0.0004);
    metrics.observe(Stage::Queue, 0.004);
    metrics.observe(Stage::Encode, 0.2);
    const std::string text = metrics.text({});
    EXPECT_TRUE(has_line(text, R"(wakesurf_stage_seconds_count{stage="queue"} 2)")) << text;
    EXPECT_TRUE(has_line(text, R"(wakesurf_stage_seconds_bucket{stage="queue",le="0.0005"} 1)"));
    EXPECT_TRUE(has_line(text, R"(wakesurf_stage_seconds_bucket{stage="queue",le="0.005"} 2)"));
    EXPECT_TRUE(has_line(text, R"(wakesurf_stage_seconds_count{stage="encode"} 1)"));
    EXPECT_TRUE(has_line(text, R"(wakesurf_stage_seconds_count{stage="send"} 0)"));
    EXPECT_EQ(metrics.quantiles(Stage::Queue).count, 2u);
    EXPECT_EQ(metrics.quantiles(Stage::Send).count, 0u);
}

TEST(MetricsTest, CountsWhatWasSentDroppedRefusedAndFailed) {
    const SetClock clock;
    Metrics metrics(clock);
    metrics.frame_sent(1000);
    metrics.frame_sent(24);
    metrics.message_sent(7);
    metrics.keyframe();
    metrics.catching_up();
    metrics.frames_dropped(5);
    metrics.reject(Rejection::Stalled);
    metrics.error(-32602);
    metrics.error(-32602);
    metrics.first_frame(0.004);
    std::string text = metrics.text({});
    for (const char* line :
         {"wakesurf_frames_sent_total 2", "wakesurf_frame_bytes_sent_total 1024",
          "wakesurf_messages_sent_total 1", "wakesurf_message_bytes_sent_total 7",
          "wakesurf_keyframes_total 1", "wakesurf_catching_up_total 1",
          "wakesurf_frames_dropped_total 5", R"(wakesurf_rejected_total{reason="stalled"} 1)",
          R"(wakesurf_rejected_total{reason="overflow"} 0)",
          R"(wakesurf_rpc_errors_total{code="-32602"} 2)",
          "wakesurf_edit_to_first_frame_seconds_count 1"})
        EXPECT_TRUE(has_line(text, line)) << line << "\n" << text;
    EXPECT_EQ(text.find("wakesurf_state_durable "), std::string::npos);
    metrics.durable(false);
    EXPECT_TRUE(has_line(metrics.text({}), "wakesurf_state_durable 0"));
    EXPECT_EQ(metrics.totals().frame_bytes, 1024u);
    EXPECT_EQ(metrics.totals().dropped, 5u);
}

TEST(MetricsTest, TellsHowTheServerStandsAndForgetsADatasetThatIsGone) {
    const SetClock clock;
    const Metrics metrics(clock);
    ServerStatus status;
    status.clients = 3;
    status.datasets = {{"ready", 2}, {"failed", 1}, {"stopped", 0}};
    status.caches.push_back({"flow \"a\"", 7, 2, 4096, 8192});
    const std::string text = metrics.text(status);
    EXPECT_TRUE(has_line(text, "wakesurf_clients 3")) << text;
    EXPECT_TRUE(has_line(text, R"(wakesurf_datasets{state="failed"} 1)")) << text;
    EXPECT_TRUE(has_line(text, R"(wakesurf_datasets{state="stopped"} 0)")) << text;
    EXPECT_TRUE(has_line(text, R"(wakesurf_cache_hits_total{dataset="flow \"a\""} 7)")) << text;
    EXPECT_TRUE(has_line(text, R"(wakesurf_cache_budget_bytes{dataset="flow \"a\""} 8192)"));
    EXPECT_GT(process_memory().resident, 1u << 20);
    EXPECT_EQ(metrics.text({}).find("dataset="), std::string::npos);
}

TEST(MetricsTest, SaysWithItsHealthHowManyDatasetsCannotBeUsedAndNamesNone) {
    using Counts = std::vector<DatasetCount>;
    EXPECT_EQ(health_text(Counts{}), "ok");
    EXPECT_EQ(health_text(Counts{{"importing", 1}, {"ready", 2}, {"failed", 0}}), "ok");
    EXPECT_EQ(health_text(Counts{{"ready", 2}, {"failed", 1}}),
              "ok, but of 3 datasets 1 has failed");
    EXPECT_EQ(health_text(Counts{{"failed", 2}, {"stopped", 1}, {"incomplete", 1}}),
              "ok, but of 4 datasets 2 have failed, 1 is incomplete");
}

TEST(MetricsTest, LosesNothingWhenAllThreadsObserve) {
    const SetClock clock;
    Metrics metrics(clock);
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&] {
            for (int n = 0; n < 5000; ++n) {
                metrics.observe(Stage::Advect, 0.001);
                metrics.frame_sent(10);
                metrics.error(n % 2 == 0 ? -32602 : -32014);
            }
        });
    for (std::thread& each : threads)
        each.join();
    const std::string text = metrics.text({});
    EXPECT_TRUE(has_line(text, R"(wakesurf_stage_seconds_count{stage="advect"} 20000)"));
    EXPECT_TRUE(has_line(text, R"(wakesurf_rpc_errors_total{code="-32014"} 10000)"));
    EXPECT_EQ(metrics.totals().frame_bytes, 200000u);
}

} // namespace wakesurf::tests::metrics_test
