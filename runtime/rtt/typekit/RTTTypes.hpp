// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_RTT_TYPES_HPP
#define ORO_RTT_TYPES_HPP

#include "Types.hpp"

#endif
