// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The plugin: everything else is in the library, which programs that use CORBA link.
#include <rtt/transports/corba/TransportPlugin.hpp>

ORO_TYPEKIT_PLUGIN(RTT::corba::CorbaLibPlugin)
