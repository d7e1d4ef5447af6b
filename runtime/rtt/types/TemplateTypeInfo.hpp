// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TEMPLATE_TYPE_INFO_HPP
#define ORO_TEMPLATE_TYPE_INFO_HPP

#include "PrimitiveTypeInfo.hpp"
#include "TemplateConnFactory.hpp"

namespace RTT {
namespace types {

/** Generator for a type that may be used everywhere, ports included; the port functions can be overridden, too. */
template <typename T, bool use_ostream = false>
class TemplateTypeInfo : public PrimitiveTypeInfo<T, use_ostream>, public TemplateConnFactory<T> {
public:
    using PrimitiveTypeInfo<T, use_ostream>::PrimitiveTypeInfo;

    bool installTypeInfoObject(TypeInfo* info) override {
        PrimitiveTypeInfo<T, use_ostream>::installTypeInfoObject(info);
        info->setThunks(&typeThunks<T>());
        info->setPortFactory(boost::dynamic_pointer_cast<TemplateTypeInfo>(this->getSharedPtr()));
        return false;
    }
};

}  // namespace types
}  // namespace RTT

#endif
