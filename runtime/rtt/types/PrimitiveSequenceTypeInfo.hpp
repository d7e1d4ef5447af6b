// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_PRIMITIVE_SEQUENCE_TYPE_INFO_HPP
#define ORO_PRIMITIVE_SEQUENCE_TYPE_INFO_HPP

#include "SequenceTypeInfo.hpp"

namespace RTT {
namespace types {

/** As SequenceTypeInfo, for containers that never travel through ports. */
template <typename T, bool has_ostream = false>
class PrimitiveSequenceTypeInfo : public PrimitiveTypeInfo<T, has_ostream>, public SequenceTypeInfoBase<T> {
public:
    explicit PrimitiveSequenceTypeInfo(std::string name) : PrimitiveTypeInfo<T, has_ostream>(std::move(name)) {}

    using SequenceTypeInfoBase<T>::composeType;
    using SequenceTypeInfoBase<T>::decomposeType;
    bool installTypeInfoObject(TypeInfo* info) override {
        PrimitiveTypeInfo<T, has_ostream>::installTypeInfoObject(info);
        this->installMembers(info, boost::dynamic_pointer_cast<PrimitiveSequenceTypeInfo>(this->getSharedPtr()),
                             !has_ostream);
        info->addConstructor(detail::newSequenceConstructor(sequenceOps<T>(), typeThunks<T>()));
        return false;
    }
};

}  // namespace types
}  // namespace RTT

#endif
