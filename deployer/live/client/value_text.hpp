// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Values of the protocol as text.
#ifndef OROFORGE_LIVE_CLIENT_VALUE_TEXT_HPP
#define OROFORGE_LIVE_CLIENT_VALUE_TEXT_HPP

#include "json.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace oroforge::live_client {

/** The value as the console shows it: `{x = 1, y = 2}`, `[1, 2, … 98 more]`, texts in quotes; on one line. */
std::string valueText(const Json& value);
/** The text of an object that has `text` or `value`; empty if it has none of them. */
std::string shownText(const Json& object);
/** A number, truth or text alone, without quotes. */
std::string plainText(const Json& value);

/** Members in the order of the type, as `pose.x` and `joints[2]`, with their values; one without a name if the value is
    no struct and no sequence. */
std::vector<std::pair<std::string, Json>> leavesOf(const Json& value);
/** The member `pose.x` or `joints[2].y`, or null if there is none. The value itself for an empty path. */
const Json* memberAt(const Json& value, const std::string& path);
/** Whether the path leads to an element of a sequence that has fewer in this value. */
bool lacksElement(const Json& value, const std::string& path);
/** The value as number: also truths, and the texts of numbers that JSON does not have ("NaN", "Infinity"). */
std::optional<double> asNumber(const Json& value);

}  // namespace oroforge::live_client

#endif
