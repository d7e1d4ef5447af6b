// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "builtin_parts.hpp"
#include "conversions.hpp"

#include <rtt/FlowStatus.hpp>
#include <rtt/SendStatus.hpp>
#include <string>

namespace RTT {
namespace types {
namespace builtin {

namespace {

/** bool from a status: is it the one of success? */
template <class Status, Status wanted, bool equal>
bool isStatus(const void*, const void* const* arguments, void* result) {
    *static_cast<bool*>(result) = (*static_cast<const Status*>(arguments[0]) == wanted) == equal;
    return true;
}

bool textOfSize(const void*, const void* const* arguments, void* result) {
    const int size = *static_cast<const int*>(arguments[0]);
    if (size < 0) return false;
    static_cast<std::string*>(result)->assign(static_cast<std::size_t>(size), '\0');
    return true;
}

constexpr Conversion conversions[] = {
    silent<bool, int>(),
    silent<bool, long long>(),
    {&typeRef<bool>, &typeRef<FlowStatus>, true, &isStatus<FlowStatus, NoData, false>},
    {&typeRef<bool>, &typeRef<WriteStatus>, true, &isStatus<WriteStatus, WriteSuccess, true>},
    {&typeRef<bool>, &typeRef<SendStatus>, true, &isStatus<SendStatus, SendSuccess, true>},
    {&typeRef<std::string>, &typeRef<int>, false, &textOfSize},
};

}  // namespace

void addOtherConversions() { addConversions(conversions); }

}  // namespace builtin
}  // namespace types
}  // namespace RTT
