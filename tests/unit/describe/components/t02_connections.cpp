// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The components of an example that is a program of its own; main() is the test's.
#include <rtt/Component.hpp>
#include <rtt/os/main.h>

#undef ORO_main
#define ORO_main(...) t02_connections_main(__VA_ARGS__)
#include "../../../../examples/t02_connections/connections.cpp"

namespace {
const RTT::ComponentFactoryLoader<Sum> sum("t02_connections/Sum");
}  // namespace
