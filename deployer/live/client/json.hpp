// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// JSON of the protocol, read without trust in the other side.
#ifndef OROFORGE_LIVE_CLIENT_JSON_HPP
#define OROFORGE_LIVE_CLIENT_JSON_HPP

#include <nlohmann/json.hpp>

#include <string>

namespace oroforge::live_client {

/** Members stay in the order of the type. */
using Json = nlohmann::ordered_json;

/** The member of an object; null if there is none, or if it is no object. */
const Json& memberOf(const Json& object, const std::string& name);
/** The member as text; empty if there is none. Values that are no texts are written as JSON. */
std::string textOf(const Json& object, const std::string& name);
/** The member as number; `otherwise` if it is none. */
double numberOf(const Json& object, const std::string& name, double otherwise = 0);
/** The member as whole number; `otherwise` if it is none. */
long long wholeOf(const Json& object, const std::string& name, long long otherwise = 0);
/** The member as truth; false if it is none. */
bool truthOf(const Json& object, const std::string& name);
/** JSON on one line. Letters that are not UTF-8 are replaced. */
std::string lineOf(const Json& value);
/** The text as JSON; discarded if it is none, or nests deeper than a value of a component does. */
Json parsed(const std::string& text);

}  // namespace oroforge::live_client

#endif
