// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TYPES_HPP
#define ORO_TYPES_HPP

#include "TypeInfo.hpp"
#include "TypeInfoGenerator.hpp"
#include "TypeInfoRepository.hpp"

#endif
