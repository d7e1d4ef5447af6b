// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Compares what travels of a struct and of a message.
#ifndef OROFORGE_TYPEKIT_GEN_MESSAGES_WIRE_MATCH_HPP
#define OROFORGE_TYPEKIT_GEN_MESSAGES_WIRE_MATCH_HPP

#include <string>
#include <utility>
#include <vector>

#include <messages/wire.hpp>

namespace oroforge::messages {

/// A difference between the two, at a field of the struct; without a line if a field is missing.
struct Difference {
    diag::Location where;
    std::string message;
    diag::Location there;  ///< the field of the message, if there is one
};

/// Each value of the struct and the one of the message at its place.
using Pairs = std::vector<std::pair<const Wire*, const Wire*>>;

/// Returns what the struct has elsewhere or otherwise, at most 8 of them; none if the bytes are those of the message.
/// Names do not matter, nor which fields are in a struct of their own. `pairs` are set if there is no difference.
std::vector<Difference> compareWires(const std::vector<Wire>& type, const std::vector<Wire>& message, Pairs& pairs);

}  // namespace oroforge::messages

#endif
