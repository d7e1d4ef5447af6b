// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The plugin: everything else is in the library, to which typekits with transporters of their own are linked.
#include <rtt/transports/mqueue/TransportPlugin.hpp>

ORO_TYPEKIT_PLUGIN(RTT::mqueue::MQLibPlugin)
