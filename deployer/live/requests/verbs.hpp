// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The verbs whose answers are made in threads of their own. They throw Failure.
#ifndef OROFORGE_LIVE_VERBS_HPP
#define OROFORGE_LIVE_VERBS_HPP

#include "lookup.hpp"
#include "requests.hpp"

namespace OCL::live {

struct Asked {
    const Root& root;
    const nlohmann::json& request;
    const Caller& caller;
    Limit limit;
};

nlohmann::json tree(const Asked& asked);
nlohmann::json show(const Asked& asked);
nlohmann::json get(const Asked& asked);
nlohmann::json set(const Asked& asked);
nlohmann::json call(const Asked& asked);
nlohmann::json lifecycle(const Asked& asked);
nlohmann::json describe(const Asked& asked);
nlohmann::json graph(const Asked& asked);
nlohmann::json lines(const Asked& asked);
nlohmann::json ports(const Asked& asked);
nlohmann::json top(const Asked& asked);

}  // namespace OCL::live

#endif
