// Who gets a permit: limits in all, and of one address while it has shown nothing; who makes room for whom.
#include "server/live/compute/budgets.hpp"
#include "server/net/admission.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace wakesurf::tests::admission_test {

using namespace server;
using boost::asio::ip::make_address;

namespace {

struct Seat {
    std::unique_ptr<Admission::Permit> permit;
    bool closed = false;
};

class AdmissionTest : public testing::Test {
  protected:
    core::SteadyClock clock_;
    Metrics metrics_{clock_};
    Admission admission_{{.connections = 10, .pending = 3, .pending_loopback = 6}, metrics_};
    std::vector<std::unique_ptr<Seat>> seats_;

    Seat* admit(const char* address, bool proxy = false) {
        auto permit = admission_.admit(make_address(address), proxy);
        if (permit == nullptr)
            return nullptr;
        seats_.push_back(std::make_unique<Seat>());
        Seat* const seat = seats_.back().get();
        seat->permit = std::move(permit);
        seat->permit->on_end([seat] { seat->closed = true; });
        return seat;
    }

    std::vector<Seat*> admit_all(const char* address, int count, bool proxy = false) {
        std::vector<Seat*> out;
        for (int i = 0; i < count; ++i)
            out.push_back(admit(address, proxy));
        return out;
    }

    static std::vector<bool> closed(const std::vector<Seat*>& seats) {
        std::vector<bool> out;
        for (const Seat* each : seats)
            out.push_back(each->closed);
        return out;
    }

    std::string counted(const char* reason) const {
        const std::string text = metrics_.text({});
        const std::string name = "wakesurf_rejected_total{reason=\"" + std::string(reason) + "\"} ";
        const auto at = text.find(name) + name.size();
        return text.substr(at, text.find('\n', at) - at);
    }
};

} // namespace

TEST_F(AdmissionTest, MakesRoomForTheNewestOfAnAddressByTheOneIdleForLongest) {
    Seat* const other = admit("192.0.2.2");
    const auto seats = admit_all("192.0.2.1", 3);
    seats[0]->permit->wait(); // it has been answered just now
    Seat* const fourth = admit("192.0.2.1");
    EXPECT_EQ(closed(seats), (std::vector<bool>{false, true, false}));
    admit("192.0.2.1");
    EXPECT_EQ(closed(seats), (std::vector<bool>{false, true, true}));
    EXPECT_FALSE(fourth->closed);
    EXPECT_FALSE(other->closed) << "another address has its own permits";
    EXPECT_EQ(admission_.connections(), 4u) << "what was closed counts no more";
    EXPECT_EQ(counted("too_many_pending"), "2");
}

TEST_F(AdmissionTest, LeavesThoseThatHaveShownATokenAlone) {
    const auto seats = admit_all("192.0.2.1", 3);
    for (Seat* each : seats)
        each->permit->let_in();
    const auto more = admit_all("192.0.2.1", 4);
    EXPECT_EQ(closed(seats), std::vector<bool>(3, false));
    EXPECT_EQ(closed(more), (std::vector<bool>{true, false, false, false}));
    seats[0]->permit->wait(); // answered: it is like the others
    EXPECT_TRUE(more[1]->closed);
}

TEST_F(AdmissionTest, WhereAllPlacesAreTakenTheAddressWithTheMostGivesOneUp) {
    const auto few = admit_all("192.0.2.1", 2);
    const auto many = admit_all("127.0.0.1", 6);
    const auto some = admit_all("192.0.2.3", 2);
    Seat* const late = admit("192.0.2.4");
    ASSERT_NE(late, nullptr);
    EXPECT_TRUE(many[0]->closed);
    EXPECT_EQ(closed(few), std::vector<bool>(2, false));
    EXPECT_EQ(closed(some), std::vector<bool>(2, false));
    EXPECT_EQ(admission_.connections(), 10u);
    for (const auto& each : seats_)
        if (!each->closed)
            each->permit->let_in();
    EXPECT_EQ(admit("192.0.2.5"), nullptr) << "no one is idle";
    EXPECT_EQ(counted("too_many_clients"), "1");
}

TEST_F(AdmissionTest, CountsAHouseholdsAddressesAsOne) {
    const auto seats = admit_all("2001:db8:1:2::1", 2);
    admit_all("2001:db8:1:2:ffff::9", 2);
    EXPECT_EQ(closed(seats), (std::vector<bool>{true, false}));
    Seat* const mapped = admit("::ffff:192.0.2.1");
    admit_all("192.0.2.1", 3);
    EXPECT_TRUE(mapped->closed);
    EXPECT_EQ(address_group(make_address("::1")), address_group(make_address("127.0.0.5")));
}

TEST_F(AdmissionTest, CountsThoseBehindAProxyByTheAddressItTells) {
    const auto seats = admit_all("192.0.2.9", 5, true); // more than one address may have
    EXPECT_EQ(closed(seats), std::vector<bool>(5, false));
    for (int i = 0; i < 4; ++i)
        seats[static_cast<std::size_t>(i)]->permit->came_from(make_address("198.51.100.7"), false);
    EXPECT_EQ(closed(seats), (std::vector<bool>{true, false, false, false, false}));
    EXPECT_EQ(seats[1]->permit->from(), "198.51.100.7");
}

TEST_F(AdmissionTest, GivesEveryPlaceBack) {
    admit_all("192.0.2.1", 9);
    admit_all("127.0.0.1", 9);
    seats_.clear();
    EXPECT_EQ(admission_.connections(), 0u);
    const auto again = admit_all("192.0.2.1", 3);
    EXPECT_EQ(closed(again), std::vector<bool>(3, false));
}

TEST(TokenBucketTest, LetsABurstThroughAndThenTheRate) {
    TokenBucket::Time now{};
    TokenBucket bucket(100.0, 10.0, now);
    for (int i = 0; i < 10; ++i)
        EXPECT_EQ(bucket.take(now, 1.0).count(), 0) << i;
    EXPECT_EQ(bucket.take(now, 1.0).count(), 10);
    now += std::chrono::milliseconds(10);
    EXPECT_EQ(bucket.take(now, 0.0).count(), 0) << "the debt is paid";
    EXPECT_EQ(bucket.wait_for(now, 1.0).count(), 10) << "and looking costs nothing";
    EXPECT_EQ(bucket.wait_for(now, 1.0).count(), 10);
    EXPECT_FALSE(bucket.full(now));
    now += std::chrono::hours(1);
    EXPECT_TRUE(bucket.full(now));
    EXPECT_EQ(bucket.take(now, 10.0).count(), 0);
    EXPECT_EQ(bucket.take(now, 1.0).count(), 10) << "no more than a burst is saved up";
}

} // namespace wakesurf::tests::admission_test
