// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_PROPERTY_COMPOSITION_HPP
#define ORO_PROPERTY_COMPOSITION_HPP

#include <rtt/types/PropertyDecomposition.hpp>  // the functions of both directions

#endif
