// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_LENIENT_HPP
#define OROFORGE_DEPLOYMENT_LENIENT_HPP

namespace OCL::deploy {

/** Lets files have text after numbers and between elements, in this process; see RTT::marsh::setLenientReading(). */
void setLenient(bool lenient);

}  // namespace OCL::deploy

#endif
