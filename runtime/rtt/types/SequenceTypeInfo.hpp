// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SEQUENCE_TYPE_INFO_HPP
#define ORO_SEQUENCE_TYPE_INFO_HPP

#include "SequenceMembers.hpp"
#include "SequenceTable.hpp"
#include "TemplateTypeInfo.hpp"

namespace RTT {
namespace types {

/** What generators for containers add to their base: elements, property bags, text form, constructors. */
template <class T>
class SequenceTypeInfoBase : public SequenceMembers {
public:
    SequenceTypeInfoBase() : SequenceMembers(sequenceOps<T>()) {}

protected:
    template <class Self>
    static void installMembers(TypeInfo* info, const boost::shared_ptr<Self>& self, bool streams) {
        info->setMemberFactory(self);
        info->setCompositionFactory(self);
        if (streams) info->setStreamFactory(boost::shared_ptr<SequenceMembers>(self));
    }
};

/** Generator for std::vector and containers like it, elements of any registered type. */
template <typename T, bool has_ostream = false>
class SequenceTypeInfo : public TemplateTypeInfo<T, has_ostream>, public SequenceTypeInfoBase<T> {
public:
    explicit SequenceTypeInfo(std::string name) : TemplateTypeInfo<T, has_ostream>(std::move(name)) {}

    using SequenceTypeInfoBase<T>::composeType;
    using SequenceTypeInfoBase<T>::decomposeType;
    bool installTypeInfoObject(TypeInfo* info) override {
        TemplateTypeInfo<T, has_ostream>::installTypeInfoObject(info);
        this->installMembers(info, boost::dynamic_pointer_cast<SequenceTypeInfo>(this->getSharedPtr()), !has_ostream);
        info->addConstructor(detail::newSequenceConstructor(sequenceOps<T>(), typeThunks<T>()));
        return false;
    }
};

}  // namespace types
}  // namespace RTT

#endif
