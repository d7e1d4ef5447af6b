// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_PORTS_HPP
#define ORO_PORTS_HPP

// The older name of Port.hpp.
#include <rtt/Port.hpp>

#endif
