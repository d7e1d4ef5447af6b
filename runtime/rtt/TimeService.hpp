// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The place of the time service before version 2.
#ifndef ORO_TIME_SERVICE_FORWARD_HPP
#define ORO_TIME_SERVICE_FORWARD_HPP
#include <rtt/os/TimeService.hpp>
#endif
