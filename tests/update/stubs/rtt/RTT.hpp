// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_TESTS_UPDATE_STUB_RTT_HPP
#define OROFORGE_TESTS_UPDATE_STUB_RTT_HPP

#include <rtt/Port.hpp>
#include <rtt/TaskContext.hpp>

#endif
