// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYMENT_LENIENT_HPP
#define OROFORGE_DEPLOYMENT_LENIENT_HPP

namespace OCL::deploy {

/** For programs: in this process, files may have text behind numbers and between elements, as RTT::marsh::setLenientReading() says. */
void setLenient(bool lenient);

}  // namespace OCL::deploy

#endif
