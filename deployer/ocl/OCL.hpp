// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/** The namespace of the component library. */
#ifndef ORO_OCL_HPP
#define ORO_OCL_HPP

#include <rtt/rtt-config.h>

namespace RTT {}

/** Components and programs built on the runtime. */
namespace OCL {
using namespace RTT;
}

/** The name of both before version 2. */
namespace Orocos {
namespace OCL = ::OCL;
using namespace ::OCL;
}  // namespace Orocos

#endif
