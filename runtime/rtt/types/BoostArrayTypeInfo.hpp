// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_BOOST_ARRAY_TYPE_INFO_HPP
#define ORO_BOOST_ARRAY_TYPE_INFO_HPP

#include "SequenceTypeInfo.hpp"

namespace RTT {
namespace types {

/** Generator for boost::array<E, N> and std::array<E, N>. Not resizable. */
template <typename T, bool has_ostream = false>
class BoostArrayTypeInfo : public TemplateTypeInfo<T, has_ostream>, public SequenceTypeInfoBase<T> {
public:
    explicit BoostArrayTypeInfo(std::string name) : TemplateTypeInfo<T, has_ostream>(std::move(name)) {}

    using SequenceTypeInfoBase<T>::composeType;
    using SequenceTypeInfoBase<T>::decomposeType;
    bool installTypeInfoObject(TypeInfo* info) override {
        TemplateTypeInfo<T, has_ostream>::installTypeInfoObject(info);
        this->installMembers(info, boost::dynamic_pointer_cast<BoostArrayTypeInfo>(this->getSharedPtr()), !has_ostream);
        return false;
    }
};

}  // namespace types
}  // namespace RTT

#endif
