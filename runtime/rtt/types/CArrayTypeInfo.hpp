// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CARRAY_TYPE_INFO_HPP
#define ORO_CARRAY_TYPE_INFO_HPP

#include "SequenceTypeInfo.hpp"
#include "carray.hpp"

namespace RTT {
namespace types {

/** Generator for carray<E>, the type of members that are C arrays. Not resizable, no ports. */
template <typename T, bool has_ostream = false>
class CArrayTypeInfo : public PrimitiveTypeInfo<T, has_ostream>, public SequenceTypeInfoBase<T> {
public:
    explicit CArrayTypeInfo(std::string name) : PrimitiveTypeInfo<T, has_ostream>(std::move(name)) {}

    using SequenceTypeInfoBase<T>::composeType;
    using SequenceTypeInfoBase<T>::decomposeType;
    bool installTypeInfoObject(TypeInfo* info) override {
        PrimitiveTypeInfo<T, has_ostream>::installTypeInfoObject(info);
        this->installMembers(info, boost::dynamic_pointer_cast<CArrayTypeInfo>(this->getSharedPtr()), !has_ostream);
        info->setArrayElement(typeid(typename T::value_type).name());
        return false;
    }
};

}  // namespace types
}  // namespace RTT

#endif
