// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_STD_BASIC_STRING_TYPE_INFO_HPP
#define ORO_STD_BASIC_STRING_TYPE_INFO_HPP

#include <rtt/types/SequenceTypeInfo.hpp>

namespace RTT {
namespace types {

/** Generator for strings: they are printed as they are, can be resized, and have members size, capacity and [index]. */
template <class T>
class StdBasicStringTypeInfo : public TemplateTypeInfo<T, true>, public SequenceTypeInfoBase<T> {
public:
    explicit StdBasicStringTypeInfo(const std::string& name) : TemplateTypeInfo<T, true>(name) {}

    bool installTypeInfoObject(TypeInfo* info) override {
        const auto self = boost::dynamic_pointer_cast<StdBasicStringTypeInfo>(this->getSharedPtr());
        TemplateTypeInfo<T, true>::installTypeInfoObject(info);
        info->setMemberFactory(self);
        // Files store a string as one text, not as a sequence, so it needs no composition factory. Reading takes the
        // whole text, blanks included.
        info->setStreamFactory(boost::shared_ptr<StreamFactory>(new WholeText()));
        return false;
    }

    Shape shape() const override {
        if constexpr (std::is_same_v<typename T::value_type, char>)
            return Shape::ofText(textOps<T>());
        else
            return SequenceTypeInfoBase<T>::shape();
    }

private:
    struct WholeText : TemplateStreamFactory<T> {
        bool fromString(const std::string& text, base::DataSourceBase::shared_ptr target) const override {
            void* storage = detail::storageOfType(target, typeid(T));
            if (!storage) return false;
            static_cast<T*>(storage)->assign(text.begin(), text.end());
            target->updated();
            return true;
        }
    };
};

}  // namespace types
}  // namespace RTT

#endif
