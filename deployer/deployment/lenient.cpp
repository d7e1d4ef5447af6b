// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "lenient.hpp"

#include <cpf/cpf_reader.hpp>

namespace OCL::deploy {

void setLenient(bool lenient) { RTT::marsh::setLenientReading(lenient); }

}  // namespace OCL::deploy
