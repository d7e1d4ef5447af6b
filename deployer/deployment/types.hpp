// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OCL_DEPLOYMENT_TYPES_HPP
#define OCL_DEPLOYMENT_TYPES_HPP

namespace OCL::deploy {

/** The types that scripts of a deployer use besides the built-in ones: `strings` and `ints`. */
void addTypes();

}  // namespace OCL::deploy

#endif
