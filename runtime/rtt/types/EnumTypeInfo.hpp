// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ENUM_TYPE_INFO_HPP
#define ORO_ENUM_TYPE_INFO_HPP

#include "CompositionFactory.hpp"
#include "StructTable.hpp"
#include "TemplateConstructor.hpp"
#include "TemplateTypeInfo.hpp"
#include <map>

namespace RTT {
namespace types {

/**
 * Generator for an enum. Derive from it and fill `to_string` in the constructor: that text is what is printed, read,
 * and written to property files. Converts silently from and to int.
 */
template <class T>
class EnumTypeInfo : public TemplateTypeInfo<T, false>, public CompositionFactory, public StreamFactory {
public:
    typedef std::map<T, std::string> MapType;

    explicit EnumTypeInfo(const std::string& name) : TemplateTypeInfo<T, false>(name) {}

    bool installTypeInfoObject(TypeInfo* info) override {
        TemplateTypeInfo<T, false>::installTypeInfoObject(info);
        const auto self = boost::dynamic_pointer_cast<EnumTypeInfo>(this->getSharedPtr());
        info->setCompositionFactory(self);
        info->setStreamFactory(self);
        info->addConstructor(newConstructor(&EnumTypeInfo::fromInt, true));
        if (TypeInfo* number = Types()->getTypeInfo<int>())
            number->addConstructor(newConstructor(&EnumTypeInfo::toInt, true));
        return false;
    }

    base::DataSourceBase::shared_ptr decomposeType(base::DataSourceBase::shared_ptr source) const override {
        return new internal::ValueDataSource<std::string>(this->toString(source));
    }
    bool composeType(base::DataSourceBase::shared_ptr source, base::DataSourceBase::shared_ptr target) const override {
        const void* text = detail::valueOfType(source, typeid(std::string));
        return text && fromString(*static_cast<const std::string*>(text), target);
    }
    std::ostream& write(std::ostream& os, base::DataSourceBase::shared_ptr source) const override {
        const void* value = detail::valueOfType(source, typeid(T));
        if (!value) return os;
        const auto known = to_string.find(*static_cast<const T*>(value));
        return known == to_string.end() ? os << toInt(*static_cast<const T*>(value)) : os << known->second;
    }
    std::istream& read(std::istream& is, base::DataSourceBase::shared_ptr target) const override {
        std::string text;
        if (is >> text && !fromString(text, target)) is.setstate(std::ios::failbit);
        return is;
    }
    bool fromString(const std::string& text, base::DataSourceBase::shared_ptr target) const override {
        void* storage = detail::storageOfType(target, typeid(T));
        for (auto it = to_string.begin(); storage && it != to_string.end(); ++it) {
            if (it->second != text) continue;
            *static_cast<T*>(storage) = it->first;
            target->updated();
            return true;
        }
        return false;
    }
    bool isStreamable() const override { return true; }

protected:
    MapType to_string;

private:
    static T fromInt(int number) { return static_cast<T>(number); }
    static int toInt(T value) { return static_cast<int>(value); }
};

}  // namespace types
}  // namespace RTT

#endif
