// Every method of the API, by noun.
#pragma once

#include "server/rpc/method.hpp"

#include <vector>

namespace wakesurf::server {

std::vector<Method> server_methods();
std::vector<Method> dataset_methods();
std::vector<Method> family_methods();
std::vector<Method> session_methods();
std::vector<Method> session_keeping_methods();
std::vector<Method> share_methods();
std::vector<Method> presence_methods();
std::vector<Method> rake_methods();
std::vector<Method> surface_methods();
std::vector<Method> subscription_methods();
std::vector<Method> bookmark_methods();
std::vector<Method> annotation_methods();
std::vector<Method> history_methods();
std::vector<Method> wait_methods();
std::vector<Method> time_methods();

/// All of the above.
std::vector<Method> method_table();

} // namespace wakesurf::server
