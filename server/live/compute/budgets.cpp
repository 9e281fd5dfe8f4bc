#include "server/live/compute/budgets.hpp"

#include "server/base/limits.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace wakesurf::server {

std::chrono::milliseconds AddressRates::wait_for(const std::string& from) {
    return of(from).wait_for(clock_.now(), 1.0);
}

void AddressRates::take(const std::string& from, double count) {
    of(from).take(clock_.now(), count);
}

TokenBucket& AddressRates::of(const std::string& from) {
    const auto now = clock_.now();
    if (left_.size() >= limits::addresses && !left_.contains(from))
        std::erase_if(left_, [now](const auto& each) { return each.second.full(now); });
    const bool room = left_.size() < limits::addresses || left_.contains(from);
    return left_.try_emplace(room ? from : std::string(), per_second_, at_once_, now).first->second;
}

namespace {

struct Kind {
    std::size_t limits::Budget::*most;
    Budgeted budgeted;
    Rejection rejection;
    const char* words;
    const char* hint;
};

constexpr std::array<Kind, 5> kinds{{
    {&limits::Budget::sockets, Budgeted::Sockets, Rejection::TooManyClients, "WebSockets",
     "close those you do not need, or try again later"},
    {&limits::Budget::requests, Budgeted::Requests, Rejection::RateLimited,
     "requests that are not answered yet", "wait for answers"},
    {&limits::Budget::downloads, Budgeted::Downloads, Rejection::RateLimited, "downloads under way",
     "wait until some have ended, a few at a time"},
    {&limits::Budget::probes, Budgeted::Probes, Rejection::RateLimited, "probes under way",
     "wait for their answers, and put many points into one"},
    {&limits::Budget::waits, Budgeted::Waits, Rejection::RateLimited,
     "calls that wait for surfaces or imports",
     "wait for answers, or end some calls with `$/cancelRequest`"},
}};

const Kind& kind_of(Use use) {
    return kinds[static_cast<std::size_t>(use)];
}

limits::Budget rest_of(limits::Budget all, const limits::Budget& kept) {
    for (const Kind& each : kinds)
        all.*each.most -= std::min(all.*each.most / 2, kept.*each.most);
    return all;
}

} // namespace

Budgets::Account::Account(const limits::Budget& of, Time now)
    : budget(&of), edits(of.edits, 2.0 * of.edits, now), calls(of.calls, 2.0 * of.calls, now),
      messages(of.messages, 2.0 * of.messages, now) {}

/// Holds what a permit takes of each account.
struct Budgets::Held {
    ~Held() {
        for (const auto& [account, use] : parts)
            --account->used[use];
    }

    std::vector<std::pair<Shared, std::size_t>> parts;
};

Budgets::Budgets(const core::Clock& clock, Metrics* metrics, const limits::Budget& all)
    : clock_(clock), metrics_(metrics), all_(all), links_(rest_of(all, limits::for_hosts)),
      everybody_(std::make_shared<Account>(all_, clock.now())),
      by_links_(std::make_shared<Account>(links_, clock.now())) {}

core::Result<Budgets::Permit> Budgets::take(const Visitor& who, Use use) {
    const Accounts accounts = of(who);
    const Kind& kind = kind_of(use);
    const auto index = static_cast<std::size_t>(use);
    const std::array<std::pair<Shared, const char*>, 4> levels{
        {{accounts.person, "you have"},
         {accounts.holder, who.grant.empty() ? "all with the server's token have"
                                             : "all who came by this share link have"},
         {accounts.links, "all who came by share links have"},
         {everybody_, "the server has"}}};
    for (const auto& [account, whose] : levels) {
        if (account == nullptr || account->used[index] < account->budget->*kind.most)
            continue;
        refused(kind.budgeted, kind.rejection);
        const std::size_t most = account->budget->*kind.most;
        return core::over_limit(
            most, fmt::format("{} reached the limit of {}: {}", whose, kind.words, most),
            kind.hint);
    }
    auto held = std::make_shared<Held>();
    for (const auto& [account, whose] : levels)
        if (account != nullptr) {
            ++account->used[index];
            held->parts.push_back({account, index});
        }
    return held;
}

std::optional<Budgets::TooFast> Budgets::call(const Visitor& who, bool edits) {
    const Accounts accounts = of(who);
    const Time now = clock_.now();
    for (const Shared& each : {accounts.person, accounts.holder}) {
        if (each == nullptr)
            continue;
        const auto calls = each->calls.wait_for(now, 1.0);
        const auto wait = std::max(calls, edits ? each->edits.wait_for(now, 1.0) : calls);
        if (wait.count() == 0)
            continue;
        refused(wait > calls ? Budgeted::Edits : Budgeted::Calls, Rejection::RateLimited);
        return TooFast{wait, wait > calls ? each->budget->edits : each->budget->calls};
    }
    for (const Shared& each : {accounts.person, accounts.holder})
        if (each != nullptr) {
            each->calls.take(now, 1.0);
            each->edits.take(now, edits ? 1.0 : 0.0);
        }
    return std::nullopt;
}

void Budgets::answered(const Visitor& who, std::size_t bytes) {
    const std::size_t more = bytes / limits::answer_bytes;
    if (more == 0)
        return;
    const Accounts accounts = of(who);
    for (const Shared& each : {accounts.person, accounts.holder})
        if (each != nullptr)
            each->calls.take(clock_.now(), static_cast<double>(more));
}

std::chrono::milliseconds Budgets::read(const Visitor& who, double messages) {
    const Accounts accounts = of(who);
    const Time now = clock_.now();
    const auto person = accounts.person != nullptr ? accounts.person->messages.take(now, messages)
                                                   : std::chrono::milliseconds::zero();
    const auto wait = std::max(person, accounts.holder->messages.take(now, messages));
    if (wait.count() > 0 && metrics_ != nullptr)
        metrics_->over_budget(Budgeted::Messages);
    return wait;
}

void Budgets::refused(Budgeted kind, Rejection reason) const {
    if (metrics_ == nullptr)
        return;
    metrics_->over_budget(kind);
    metrics_->reject(reason);
}

std::size_t Budgets::used(Use use) const {
    return everybody_->used[static_cast<std::size_t>(use)];
}

std::string Budgets::line(const Visitor& who) {
    return who.grant.empty() ? "\n" + who.person : line_of(who.account());
}

std::string Budgets::line_of(const std::string& link) {
    return "\nlink " + link; // no session is called like that
}

/// A script with the server's token has no login of its own, and all of one machine would be one person.
Budgets::Accounts Budgets::of(const Visitor& who) {
    Accounts out;
    const bool token = who.grant.empty();
    if (!token || who.person.starts_with("login "))
        out.person = account(who.account() + "\n" + who.person, limits::person);
    out.holder = account(who.account(), token ? limits::token : limits::link);
    out.links = token ? nullptr : by_links_;
    return out;
}

Budgets::Shared Budgets::account(const std::string& key, const limits::Budget& budget) {
    if (accounts_.size() >= sweep_at_)
        forget_idle();
    Shared& found = accounts_[key];
    if (found == nullptr)
        found = std::make_shared<Account>(budget, clock_.now());
    return found;
}

/// Those that are as new ones would be.
void Budgets::forget_idle() {
    const Time now = clock_.now();
    std::erase_if(accounts_, [now](auto& each) {
        Account& account = *each.second;
        return each.second.use_count() == 1 && account.messages.full(now) &&
               account.calls.full(now) && account.edits.full(now);
    });
    sweep_at_ = std::max<std::size_t>(1024, 2 * accounts_.size());
}

} // namespace wakesurf::server
