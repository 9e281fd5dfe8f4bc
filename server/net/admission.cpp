#include "server/net/admission.hpp"

#include "server/base/limits.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <utility>

namespace wakesurf::server {

namespace {

using boost::asio::ip::address;

constexpr std::size_t descriptors_for_files = 64;

const std::string loopback = "loopback";

} // namespace

address plain_address(const address& given) {
    if (given.is_v6() && given.to_v6().is_v4_mapped())
        return boost::asio::ip::make_address_v4(boost::asio::ip::v4_mapped, given.to_v6());
    return given;
}

std::string address_group(const address& given) {
    const address who = plain_address(given);
    if (who.is_loopback())
        return loopback;
    if (who.is_v4())
        return who.to_string();
    auto bytes = who.to_v6().to_bytes();
    std::fill(bytes.begin() + 8, bytes.end(), static_cast<unsigned char>(0));
    return boost::asio::ip::address_v6(bytes).to_string() + "/64";
}

std::unique_ptr<Admission::Permit> Admission::admit(const address& who, bool proxy) {
    if (connections_ >= limits_.connections && !make_room_in_all()) {
        metrics_.reject(Rejection::TooManyClients);
        return nullptr;
    }
    return std::make_unique<Permit>(*this, address_group(who), proxy);
}

std::size_t Admission::most(const Permit& permit) const {
    return permit.proxy_ || permit.address_ == loopback ? limits_.pending_loopback
                                                        : limits_.pending;
}

/// Evicts a connection of the address with the most.
bool Admission::make_room_in_all() {
    const auto largest =
        std::max_element(pending_.begin(), pending_.end(), [](const auto& a, const auto& b) {
            return a.second.size() < b.second.size();
        });
    if (largest == pending_.end())
        return false;
    make_room(largest->second);
    return true;
}

void Admission::make_room(Pending& among) {
    Permit& oldest = *among.front();
    metrics_.reject(Rejection::TooManyPending);
    oldest.leave();
    oldest.counted_ = false;
    --connections_;
    if (const auto end = std::exchange(oldest.end_, nullptr))
        end();
}

Admission::Permit::Permit(Admission& owner, std::string address, bool proxy)
    : owner_(owner), number_(++owner.last_number_), address_(std::move(address)), proxy_(proxy) {
    ++owner_.connections_;
    wait();
}

Admission::Permit::~Permit() {
    leave();
    if (counted_)
        --owner_.connections_;
}

void Admission::Permit::let_in() {
    leave();
}

void Admission::Permit::wait() {
    leave();
    if (!counted_)
        return;
    if (const auto found = owner_.pending_.find(address_);
        found != owner_.pending_.end() && found->second.size() >= owner_.most(*this))
        owner_.make_room(found->second);
    Pending& own = owner_.pending_[address_];
    at_ = own.insert(own.end(), this);
    pending_ = true;
}

void Admission::Permit::came_from(const address& address, bool proxy) {
    const bool waiting = pending_;
    leave();
    address_ = address_group(address);
    proxy_ = proxy;
    if (waiting)
        wait();
}

void Admission::Permit::leave() {
    if (!std::exchange(pending_, false))
        return;
    const auto found = owner_.pending_.find(address_);
    found->second.erase(at_);
    if (found->second.empty())
        owner_.pending_.erase(found);
}

Admission::Limits limits_for_descriptors() {
    Admission::Limits out{limits::connections, limits::pending, limits::pending_loopback};
    rlimit descriptors{};
    if (::getrlimit(RLIMIT_NOFILE, &descriptors) != 0)
        return out;
    const rlim_t wanted = limits::connections + descriptors_for_files;
    if (descriptors.rlim_cur < wanted) {
        descriptors.rlim_cur = std::min(descriptors.rlim_max, wanted);
        ::setrlimit(RLIMIT_NOFILE, &descriptors);
        ::getrlimit(RLIMIT_NOFILE, &descriptors);
    }
    const auto allowed = static_cast<std::size_t>(std::min(descriptors.rlim_cur, wanted));
    const auto kept_back = std::min(descriptors_for_files, allowed / 2);
    out.connections = std::min(out.connections, allowed - kept_back);
    return out;
}

} // namespace wakesurf::server
