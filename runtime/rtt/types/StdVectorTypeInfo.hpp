// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TEMPLATE_STDVECTOR_INFO_HPP
#define ORO_TEMPLATE_STDVECTOR_INFO_HPP

#include "SequenceTypeInfo.hpp"
#include <vector>

namespace RTT {
namespace types {

/** Generator for std::vector<Element>; that of double is registered as "array". */
template <class Element = double>
class StdVectorTypeInfo : public SequenceTypeInfo<std::vector<Element>> {
public:
    explicit StdVectorTypeInfo(const std::string& name = "array") : SequenceTypeInfo<std::vector<Element>>(name) {}
};

}  // namespace types
}  // namespace RTT

#endif
