// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "builtin_parts.hpp"
#include "conversions.hpp"

#include <rtt/FlowStatus.hpp>
#include <rtt/SendStatus.hpp>
#include <rtt/rt_string.hpp>
#include <new>
#include <string>

namespace RTT::types::builtin {

namespace {

/** Converts a status to bool by comparing it with `wanted`. */
template <class Status, Status wanted, bool equal>
bool isStatus(const void*, const void* const* arguments, void* result) {
    *static_cast<bool*>(result) = (*static_cast<const Status*>(arguments[0]) == wanted) == equal;
    return true;
}

/** False if the assignment runs out of memory: that of real-time strings is limited. */
template <class F>
bool ifMemorySuffices(F assign) {
    try {
        assign();
        return true;
    } catch (const std::bad_alloc&) {
        return false;
    }
}

template <class Text>
bool textOfSize(const void*, const void* const* arguments, void* result) {
    const int size = *static_cast<const int*>(arguments[0]);
    if (size < 0) return false;
    return ifMemorySuffices([&] { static_cast<Text*>(result)->assign(static_cast<std::size_t>(size), '\0'); });
}

/** Copies between strings of the heap and of real-time memory. */
template <class To, class From>
bool copyText(const void*, const void* const* arguments, void* result) {
    const From& from = *static_cast<const From*>(arguments[0]);
    return ifMemorySuffices([&] { static_cast<To*>(result)->assign(from.data(), from.size()); });
}

constexpr Conversion conversions[] = {
    silent<bool, int>(),
    silent<bool, long long>(),
    {&typeRef<bool>, &typeRef<FlowStatus>, true, &isStatus<FlowStatus, NoData, false>},
    {&typeRef<bool>, &typeRef<WriteStatus>, true, &isStatus<WriteStatus, WriteSuccess, true>},
    {&typeRef<bool>, &typeRef<SendStatus>, true, &isStatus<SendStatus, SendSuccess, true>},
    {&typeRef<std::string>, &typeRef<int>, false, &textOfSize<std::string>},
    {&typeRef<rt_string>, &typeRef<int>, false, &textOfSize<rt_string>},
    {&typeRef<std::string>, &typeRef<rt_string>, false, &copyText<std::string, rt_string>},
    {&typeRef<rt_string>, &typeRef<std::string>, false, &copyText<rt_string, std::string>},
};

}  // namespace

void addOtherConversions() { addConversions(conversions); }

}  // namespace RTT::types::builtin
