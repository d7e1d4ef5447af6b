// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_CHAIN_TYPES_HPP
#define OROFORGE_CHAIN_TYPES_HPP

namespace OCL::chain {

/** Makes the types of ChainStatistics.hpp known, if they are not. The library that has them is never unloaded. */
void addTypes();

}  // namespace OCL::chain

#endif
