// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/** The component macros, for older component libraries that include this header. */
#ifndef ORO_OCL_COMPONENT_HPP
#define ORO_OCL_COMPONENT_HPP

#include <ocl/OCL.hpp>
#include <rtt/Component.hpp>

namespace OCL {
using RTT::ComponentFactories;
using RTT::ComponentLoaderSignature;
using RTT::FactoryMap;
}  // namespace OCL

#endif
