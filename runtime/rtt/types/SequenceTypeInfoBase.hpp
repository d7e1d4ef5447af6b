// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The members of sequences, for generators that derive from this and another base.
#ifndef ORO_SEQUENCE_TYPE_INFO_BASE_HPP
#define ORO_SEQUENCE_TYPE_INFO_BASE_HPP
#include <rtt/internal/FusedFunctorDataSource.hpp>  // typekits take newFunctorDataSource() from here
#include <rtt/types/SequenceTypeInfo.hpp>
#endif
