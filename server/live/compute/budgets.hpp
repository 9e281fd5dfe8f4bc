// Limits what each person, each share link and all links together use of the server, over all their
// WebSockets and HTTP requests: how many of a kind at a time, and how many calls, edits and messages a
// second. It is asked before anything is done, and a refusal says whose limit was reached. The last of each
// kind are for clients with the server's own token, so that a host can always enter and revoke a link.
#pragma once

#include "core/base/clock.hpp"
#include "core/base/result.hpp"
#include "server/base/identity.hpp"
#include "server/base/limits.hpp"
#include "server/base/metrics.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace wakesurf::server {

/// A rate with room for bursts: tokens come at a steady rate up to a most, and a caller without one waits.
class TokenBucket {
  public:
    using Time = std::chrono::steady_clock::time_point;

    /// Begins full.
    TokenBucket(double per_second, double most, Time now)
        : per_second_(per_second), most_(most), left_(most), at_(now) {}

    /// Takes `tokens`, on credit if need be. Returns how long to wait until there is no debt: zero where
    /// there is none.
    std::chrono::milliseconds take(Time now, double tokens) {
        left_ = at(now) - tokens;
        at_ = now;
        return until(0.0, left_);
    }

    /// Returns how long to wait until there are as many tokens; zero if there are.
    std::chrono::milliseconds wait_for(Time now, double tokens) const {
        return until(tokens, at(now));
    }

    /// Returns whether it is full, as at the beginning.
    bool full(Time now) const { return at(now) >= most_; }

  private:
    double at(Time now) const {
        const double elapsed = std::chrono::duration<double>(now - at_).count();
        return std::min(most_, left_ + elapsed * per_second_);
    }

    std::chrono::milliseconds until(double tokens, double left) const {
        if (left >= tokens)
            return {};
        return std::chrono::ceil<std::chrono::milliseconds>(
            std::chrono::duration<double>((tokens - left) / per_second_));
    }

    double per_second_;
    double most_;
    double left_;
    Time at_;
};

/// The kinds of use that are counted while they last; see limits::Budget.
enum class Use : std::uint8_t { Socket, Request, Download, Probe, Wait };

/// Loop thread only. Cost of a call: O(log people).
class Budgets {
  public:
    /// Holds one of a kind until it is destroyed.
    using Permit = std::shared_ptr<void>;

    /// Tells how long to wait, and the limit that was reached.
    struct TooFast {
        std::chrono::milliseconds retry_after;
        double limit; ///< a second
    };

    /// @param all      of everybody: limits::all, less where the process may have fewer descriptors
    /// @param metrics  counts refusals; may be null
    explicit Budgets(const core::Clock& clock,
                     Metrics* metrics = nullptr,
                     const limits::Budget& all = limits::all);
    Budgets(const Budgets&) = delete;
    Budgets& operator=(const Budgets&) = delete;

    /// Error: OverLimit, naming whose limit it is. The permit may outlive the budgets.
    core::Result<Permit> take(const Visitor& who, Use use);

    /// Takes one call, unless they come too fast.
    std::optional<TooFast> call(const Visitor& who, bool edits);

    /// Takes the calls that an answer of so many bytes counts for beyond its own, on credit.
    void answered(const Visitor& who, std::size_t bytes);

    /// Takes messages that have been read, on credit. Returns how long to read no further.
    std::chrono::milliseconds read(const Visitor& who, double messages);

    /// Returns how many of a kind all clients use.
    std::size_t used(Use use) const;

    /// Returns the name under which work of no session queues in the compute pool. All clients that came by
    /// one link share one.
    static std::string line(const Visitor& who);
    /// Returns the same of all who came by the link.
    static std::string line_of(const std::string& link);

  private:
    using Time = std::chrono::steady_clock::time_point;

    struct Account {
        Account(const limits::Budget& budget, Time now);

        const limits::Budget* budget;
        std::array<std::size_t, 5> used{};
        TokenBucket edits;
        TokenBucket calls;
        TokenBucket messages;
    };

    using Shared = std::shared_ptr<Account>;
    struct Held;

    /// Holds the accounts that a caller is charged to: the person where the caller is one of many by a
    /// link, the link or the token, and all links.
    struct Accounts {
        Shared person; ///< nothing: a script with the server's token
        Shared holder;
        Shared links; ///< nothing for the token
    };

    void refused(Budgeted kind, Rejection reason) const;
    Accounts of(const Visitor& who);
    Shared account(const std::string& key, const limits::Budget& budget);
    void forget_idle();

    const core::Clock& clock_;
    Metrics* metrics_;
    limits::Budget all_;
    limits::Budget links_; ///< together
    Shared everybody_;
    Shared by_links_;
    std::map<std::string, Shared> accounts_;
    std::size_t sweep_at_ = 1024;
};

/// A rate for each address that asks, of what needs no token. Beyond limits::addresses of them the further
/// ones share one.
/// Loop thread only.
class AddressRates {
  public:
    /// REQUIRES: the clock outlives it.
    AddressRates(double per_second, double at_once, const core::Clock& clock)
        : per_second_(per_second), at_once_(at_once), clock_(clock) {}

    /// Returns how long to wait until one more may come; zero if it may come now.
    std::chrono::milliseconds wait_for(const std::string& from);

    /// On credit, if need be.
    void take(const std::string& from, double count);

  private:
    TokenBucket& of(const std::string& from);

    double per_second_;
    double at_once_;
    const core::Clock& clock_;
    std::map<std::string, TokenBucket> left_;
};

} // namespace wakesurf::server
