// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The generator of "array".
#ifndef ORO_TYPEKIT_STD_VECTOR_TYPE_INFO_HPP
#define ORO_TYPEKIT_STD_VECTOR_TYPE_INFO_HPP
#include <rtt/types/StdVectorTypeInfo.hpp>
#endif
