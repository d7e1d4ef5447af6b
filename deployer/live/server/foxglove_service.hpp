// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Operations as services of Foxglove's protocol: a request is an object of the arguments by name, a response one of
// "result", unless the operation gives nothing back, and of the arguments that it changes.
#ifndef OROFORGE_LIVE_FOXGLOVE_SERVICE_HPP
#define OROFORGE_LIVE_FOXGLOVE_SERVICE_HPP

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace OCL::live {

/** `operation` as in the answer to oro.show. */
nlohmann::json foxgloveService(std::uint32_t id, const std::string& name, const std::string& type,
                               const nlohmann::json& operation);
/** The arguments of a request, in the order of `names`. Null, with the reason, if one is missing or has another
    name. */
nlohmann::json foxgloveArguments(const std::vector<std::string>& names, const nlohmann::json& request,
                                 std::string& why);
/** The response; `result` as in the answer to oro.call. */
nlohmann::json foxgloveResult(const nlohmann::json& result);

}  // namespace OCL::live

#endif
