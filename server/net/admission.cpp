#include "server/net/admission.hpp"

#include "server/limits.hpp"

#include <sys/resource.h>

#include <algorithm>

namespace wakesurf::server {

namespace {

using boost::asio::ip::address;

constexpr std::size_t descriptors_for_files = 64;

/// IPv4 in IPv6 clothes is IPv4.
address plain(const address& given) {
    if (given.is_v6() && given.to_v6().is_v4_mapped())
        return boost::asio::ip::make_address_v4(boost::asio::ip::v4_mapped, given.to_v6());
    return given;
}

const std::string loopback = "loopback";

} // namespace

std::string address_group(const address& given) {
    const address who = plain(given);
    if (who.is_loopback())
        return loopback;
    if (who.is_v4())
        return who.to_string();
    auto bytes = who.to_v6().to_bytes();
    std::fill(bytes.begin() + 8, bytes.end(), static_cast<unsigned char>(0));
    return boost::asio::ip::address_v6(bytes).to_string() + "/64";
}

std::unique_ptr<Admission::Place> Admission::admit(const address& who) {
    if (connections_ >= limits_.connections) {
        metrics_.reject(Rejection::TooManyClients);
        return nullptr;
    }
    std::string group = address_group(who);
    const auto most = group == loopback ? limits_.pending_loopback : limits_.pending;
    const auto found = pending_.find(group);
    if (found != pending_.end() && found->second >= most) {
        metrics_.reject(Rejection::TooManyPending);
        return nullptr;
    }
    return std::make_unique<Place>(*this, std::move(group));
}

Admission::Place::Place(Admission& owner, std::string address)
    : owner_(owner), number_(++owner.last_number_), address_(std::move(address)) {
    ++owner_.connections_;
    ++owner_.pending_[address_];
}

Admission::Place::~Place() {
    --owner_.connections_;
    if (address_.empty())
        --owner_.clients_;
    else if (const auto found = owner_.pending_.find(address_); --found->second == 0)
        owner_.pending_.erase(found);
}

bool Admission::Place::promote() {
    if (owner_.clients_ >= owner_.limits_.clients) {
        owner_.metrics_.reject(Rejection::TooManyClients);
        return false;
    }
    ++owner_.clients_;
    if (const auto found = owner_.pending_.find(address_); --found->second == 0)
        owner_.pending_.erase(found);
    address_.clear();
    return true;
}

Admission::Limits limits_for_descriptors() {
    Admission::Limits out{limits::connections, limits::clients, limits::pending,
                          limits::pending_loopback};
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
