// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The components of an example that is a program of its own; main() is the test's.
#include <rtt/Component.hpp>
#include <rtt/os/main.h>

#undef ORO_main
#define ORO_main(...) t05_operations_main(__VA_ARGS__)
#include "../../../../examples/t05_operations/operations.cpp"

namespace {
const RTT::ComponentFactoryLoader<Axis> axis("t05_operations/Axis");
const RTT::ComponentFactoryLoader<Planner> planner("t05_operations/Planner");
}  // namespace
