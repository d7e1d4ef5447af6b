// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/** The component loader, for older programs that include this header. */
#ifndef ORO_OCL_COMPONENT_LOADER_HPP
#define ORO_OCL_COMPONENT_LOADER_HPP

#include <ocl/OCL.hpp>
#include <rtt/deployment/ComponentLoader.hpp>

namespace OCL {
using RTT::ComponentLoader;
}

#endif
