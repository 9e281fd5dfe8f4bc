// When the answer to an edit goes out, and what it says of durability.
#include "server/net/methods/method.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <optional>
#include <utility>
#include <vector>

namespace wakesurf::server::held_answer_test {

using nlohmann::json;

namespace {

/// Settles when the test says so.
struct HandJournal final : Journal {
    void write(const std::string&, std::vector<JournalEntry>) override {}

    void remove(const std::string&) override {}

    void settled(std::function<void(core::Result<void>)> done) override {
        waiting.push_back(std::move(done));
    }

    void settle(const core::Result<void>& outcome) {
        for (const auto& each : std::exchange(waiting, {}))
            each(outcome);
    }

    std::vector<std::function<void(core::Result<void>)>> waiting;
};

class HeldAnswer : public testing::Test {
  protected:
    Reply reply() {
        return held_until_settled(Reply([this](const Reply::Outcome& outcome) {
                                      EXPECT_FALSE(result || fault) << "answered twice";
                                      if (outcome.result != nullptr)
                                          result = *outcome.result;
                                      else
                                          fault = *outcome.fault;
                                  }),
                                  journal);
    }

    HandJournal journal;
    std::optional<json> result;
    std::optional<protocol::RpcFault> fault;
};

} // namespace

TEST_F(HeldAnswer, WaitsForTheDisk) {
    reply().result({{"rake", "r1"}});
    EXPECT_FALSE(result);
    journal.settle({});
    EXPECT_EQ(*result, json({{"rake", "r1"}, {"durable", true}}));
}

TEST_F(HeldAnswer, StaysAResultWhereTheDiskRefusesAndSaysWhy) {
    reply().result({{"rake", "r1"}});
    journal.settle(core::fail(core::Error::Code::Io, "the disk is full", "make room"));
    EXPECT_EQ(*result,
              json({{"rake", "r1"}, {"durable", false}, {"hint", "the disk is full: make room"}}));
}

TEST_F(HeldAnswer, HoldsNoErrorUp) {
    reply().fault(core::Error{core::Error::Code::NotFound, "there is no rake", ""});
    EXPECT_EQ(fault->message, "there is no rake");
    EXPECT_TRUE(journal.waiting.empty());
}

TEST_F(HeldAnswer, AnswersACallThatWasForgotten) {
    { const Reply forgotten = reply(); }
    EXPECT_EQ(fault->code, protocol::RpcCode::Internal);
}

TEST_F(HeldAnswer, AnswersWhereTheJournalEndsFirst) {
    reply().result({{"rake", "r1"}});
    journal.waiting.clear();
    EXPECT_TRUE(fault);
}

} // namespace wakesurf::server::held_answer_test
