// A visitor: what the token or link allows, and which of its holders this is.
#pragma once

#include "server/base/identity.hpp"

#include <string>
#include <utility>

namespace wakesurf::server {

struct Visitor : Identity {
    Visitor(Identity identity = {}, std::string who = {})
        : Identity(std::move(identity)), person(std::move(who)) {}

    /// The person, as far as known: the login of a browser, else the address. May be empty.
    std::string person;
};

} // namespace wakesurf::server
