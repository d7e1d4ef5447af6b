// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Everything a component usually needs.
#ifndef ORO_RTT_HPP
#define ORO_RTT_HPP

#include <rtt/TaskContext.hpp>
#include <rtt/usual_includes.hpp>

#endif
