// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Units of time.
#ifndef ORO_OS_TIME_HPP
#define ORO_OS_TIME_HPP
#include <rtt/Time.hpp>
#endif
