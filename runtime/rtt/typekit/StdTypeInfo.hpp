// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_STD_TYPE_INFO_HPP
#define ORO_STD_TYPE_INFO_HPP

#include <rtt/types/TemplateTypeInfo.hpp>

namespace RTT {
namespace types {

/** Generator for numbers and the like, which have stream operators. */
template <typename T>
class StdTypeInfo : public TemplateTypeInfo<T, true> {
public:
    explicit StdTypeInfo(const std::string& name) : TemplateTypeInfo<T, true>(name) {}
};

}  // namespace types
}  // namespace RTT

#endif
