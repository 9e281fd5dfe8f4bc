// Who gets a place: limits in all, for WebSockets, and of one address while it has shown nothing.
#include "server/net/admission.hpp"
#include "server/net/token_bucket.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace wakesurf::tests {

using namespace server;
using boost::asio::ip::make_address;

namespace {

class AdmissionTest : public testing::Test {
  protected:
    core::SteadyClock clock_;
    Metrics metrics_{clock_};
    Admission admission_{{.connections = 10, .clients = 4, .pending = 3, .pending_loopback = 6},
                         metrics_};
    std::vector<std::unique_ptr<Admission::Place>> places_;

    bool admit(const char* address) {
        auto place = admission_.admit(make_address(address));
        const bool good = place != nullptr;
        if (good)
            places_.push_back(std::move(place));
        return good;
    }

    int admitted(const char* address, int tries) {
        int count = 0;
        for (int i = 0; i < tries; ++i)
            count += admit(address) ? 1 : 0;
        return count;
    }
};

} // namespace

TEST_F(AdmissionTest, OneAddressCannotTakeTheOthersPlaces) {
    EXPECT_EQ(admitted("192.0.2.1", 9), 3);
    EXPECT_EQ(admitted("192.0.2.2", 9), 3);
    EXPECT_EQ(admitted("127.0.0.1", 9), 4) << "ten in all";
    EXPECT_NE(metrics_.text({}).find(R"(wakesurf_rejected_total{reason="too_many_pending"} 12)"),
              std::string::npos);
    EXPECT_NE(metrics_.text({}).find(R"(wakesurf_rejected_total{reason="too_many_clients"} 5)"),
              std::string::npos);
}

TEST_F(AdmissionTest, CountsAHouseholdsAddressesAsOne) {
    EXPECT_EQ(admitted("2001:db8:1:2::1", 2), 2);
    EXPECT_EQ(admitted("2001:db8:1:2:ffff::9", 2), 1);
    EXPECT_EQ(admitted("2001:db8:1:3::1", 1), 1);
    EXPECT_EQ(admitted("::ffff:192.0.2.1", 2), 2);
    EXPECT_EQ(admitted("192.0.2.1", 2), 1);
    EXPECT_EQ(address_group(make_address("::1")), address_group(make_address("127.0.0.5")));
}

TEST_F(AdmissionTest, APlaceThatIsAWebSocketIsNotPendingAnyMore) {
    EXPECT_EQ(admitted("192.0.2.1", 9), 3);
    for (auto& place : places_)
        EXPECT_TRUE(place->promote());
    EXPECT_EQ(admission_.clients(), 3u);
    EXPECT_EQ(admitted("192.0.2.1", 9), 3);
    EXPECT_TRUE(places_[3]->promote());
    EXPECT_FALSE(places_[4]->promote()) << "four WebSockets at most";
    EXPECT_EQ(admission_.connections(), 6u);
    places_.clear();
    EXPECT_EQ(admission_.connections(), 0u);
    EXPECT_EQ(admission_.clients(), 0u);
    EXPECT_EQ(admitted("192.0.2.1", 9), 3) << "all places are given back";
}

TEST(TokenBucketTest, LetsABurstThroughAndThenTheRate) {
    TokenBucket::Time now{};
    TokenBucket bucket(100.0, 10.0, now);
    for (int i = 0; i < 10; ++i)
        EXPECT_EQ(bucket.take(now, 1.0).count(), 0) << i;
    EXPECT_EQ(bucket.take(now, 1.0).count(), 10);
    now += std::chrono::milliseconds(10);
    EXPECT_EQ(bucket.take(now, 0.0).count(), 0) << "the debt is paid";
    now += std::chrono::hours(1);
    EXPECT_EQ(bucket.take(now, 10.0).count(), 0);
    EXPECT_EQ(bucket.take(now, 1.0).count(), 10) << "no more than a burst is saved up";
}

} // namespace wakesurf::tests
