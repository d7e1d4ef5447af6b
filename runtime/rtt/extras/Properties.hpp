// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_EXTRAS_PROPERTIES_HPP
#define ORO_EXTRAS_PROPERTIES_HPP

#include <rtt/Properties.hpp>

#endif
