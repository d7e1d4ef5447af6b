// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "builtin_parts.hpp"

#include <rtt/Attribute.hpp>
#include <rtt/ConnPolicy.hpp>
#include <rtt/FlowStatus.hpp>
#include <rtt/SendStatus.hpp>
#include <rtt/os/fosi.h>
#include <rtt/types/GlobalsRepository.hpp>

namespace RTT::types::builtin {

namespace {

/** Adds a name, unless a user has added it already. */
template <class T>
void add(const char* name, T value) {
    const auto globals = GlobalsRepository::Instance();
    if (!globals->hasAttribute(name)) globals->setValue(new Constant<T>(name, value));
}

}  // namespace

void addGlobals() {
    add("NoData", NoData);
    add("OldData", OldData);
    add("NewData", NewData);
    add("WriteSuccess", WriteSuccess);
    add("WriteFailure", WriteFailure);
    add("NotConnected", NotConnected);
    add("CollectFailure", CollectFailure);
    add("SendFailure", SendFailure);
    add("SendNotReady", SendNotReady);
    add("SendSuccess", SendSuccess);
    add<int>("UNBUFFERED", ConnPolicy::UNBUFFERED);
    add<int>("DATA", ConnPolicy::DATA);
    add<int>("BUFFER", ConnPolicy::BUFFER);
    add<int>("CIRCULAR_BUFFER", ConnPolicy::CIRCULAR_BUFFER);
    add<int>("LOCKED", ConnPolicy::LOCKED);
    add<int>("LOCK_FREE", ConnPolicy::LOCK_FREE);
    add<int>("UNSYNC", ConnPolicy::UNSYNC);
    add("UnspecifiedBufferPolicy", UnspecifiedBufferPolicy);
    add("PerConnection", PerConnection);
    add("PerInputPort", PerInputPort);
    add("PerOutputPort", PerOutputPort);
    add("Shared", Shared);
    add<int>("ORO_SCHED_RT", ORO_SCHED_RT);
    add<int>("ORO_SCHED_OTHER", ORO_SCHED_OTHER);
    add<int>("ORO_WAIT_ABS", ORO_WAIT_ABS);
    add<int>("ORO_WAIT_REL", ORO_WAIT_REL);
    GlobalsRepository::Instance()->addAttribute("DefaultConnPolicy", ConnPolicy::Default());
}

}  // namespace RTT::types::builtin
