// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TEMPLATE_STDVECTOR_INFO_HPP
#define ORO_TEMPLATE_STDVECTOR_INFO_HPP

#include "SequenceTypeInfo.hpp"
#include <vector>

namespace RTT {
namespace types {

/** Generator for std::vector<double>, registered as "array". */
class StdVectorTypeInfo : public SequenceTypeInfo<std::vector<double>> {
public:
    explicit StdVectorTypeInfo(const std::string& name = "array") : SequenceTypeInfo<std::vector<double>>(name) {}
};

}  // namespace types
}  // namespace RTT

#endif
