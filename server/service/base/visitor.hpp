// Who asks: what the token or link lets them do, and which of those who have it they are.
#pragma once

#include "server/service/base/identity.hpp"

#include <string>
#include <utility>

namespace wakesurf::server {

struct Visitor : Identity {
    Visitor(Identity identity = {}, std::string who = {})
        : Identity(std::move(identity)), person(std::move(who)) {}

    /// Names the person, as far as can be told: the login of a browser, else the address. May be empty.
    std::string person;
};

} // namespace wakesurf::server
