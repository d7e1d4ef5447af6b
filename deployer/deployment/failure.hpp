// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Reports why an operation of the deployer returns false.
#ifndef OROFORGE_DEPLOYMENT_FAILURE_HPP
#define OROFORGE_DEPLOYMENT_FAILURE_HPP

#include <rtt/internal/calls/failed.hpp>

namespace OCL::deploy {

using RTT::internal::doneOr;
using RTT::internal::failed;
using RTT::internal::reported;

}  // namespace OCL::deploy

#endif
