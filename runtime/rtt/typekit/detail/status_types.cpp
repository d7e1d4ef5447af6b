// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "builtin_parts.hpp"

#include <rtt/FlowStatus.hpp>
#include <rtt/SendStatus.hpp>
#include <rtt/types/GeneratedTypekit.hpp>
#include <rtt/types/Types.hpp>

namespace RTT::types::builtin {

namespace {
constexpr Enumerator flowStatus[] = {
    {"NoData", NoData, "nothing was ever written"},
    {"OldData", OldData, "nothing new since the last read"},
    {"NewData", NewData, "written since the last read"},
};
constexpr Enumerator writeStatus[] = {
    {"WriteSuccess", WriteSuccess, ""},
    {"WriteFailure", WriteFailure, "a channel could not take the sample"},
    {"NotConnected", NotConnected, ""},
};
constexpr Enumerator sendStatus[] = {
    {"CollectFailure", CollectFailure, ""},
    {"SendFailure", SendFailure, ""},
    {"SendNotReady", SendNotReady, ""},
    {"SendSuccess", SendSuccess, ""},
};
}  // namespace

void addStatusTypes() {
    Types()->addType(makeEnumType<FlowStatus>("FlowStatus", flowStatus, 3));
    Types()->addType(makeEnumType<WriteStatus>("WriteStatus", writeStatus, 3));
    Types()->addType(makeEnumType<SendStatus>("SendStatus", sendStatus, 4));
}

}  // namespace RTT::types::builtin
