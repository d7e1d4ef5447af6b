// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_ENUM_TYPE_INFO_HPP
#define ORO_ENUM_TYPE_INFO_HPP

#include "CompositionFactory.hpp"
#include "Shape.hpp"
#include "StructTable.hpp"
#include "TemplateConstructor.hpp"
#include "TemplateTypeInfo.hpp"
#include <map>

namespace RTT {
namespace types {

namespace detail {
/** False if the text is anything else than a whole number in the range of int. */
RTT_API bool readNumber(const std::string& text, int& number);
}  // namespace detail

/**
 * Generator for an enum. Derive from it and fill `to_string` in the constructor: that text is what is printed, read,
 * and written to property files; for a value without text it is the number, as an int. Converts silently from and to
 * int.
 */
template <class T>
class EnumTypeInfo : public TemplateTypeInfo<T, false>,
                     public CompositionFactory,
                     public Enumeration,
                     public StreamFactory,
                     public HasShape {
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

    Shape shape() const override {
        Shape shape;
        shape.kind = Shape::Kind::Enumeration;
        shape.numbers = &enumOps<T>();
        for (const auto& known : to_string)
            shape.enumerators.push_back({known.second, shape.numbers->get(&known.first)});
        return shape;
    }

    base::DataSourceBase::shared_ptr decomposeType(base::DataSourceBase::shared_ptr source) const override {
        const void* value = detail::valueOfType(source, typeid(T));
        if (!value) return nullptr;
        if (const std::string* text = textOf(*static_cast<const T*>(value)))
            return new internal::ValueDataSource<std::string>(*text);
        return new internal::ValueDataSource<int>(toInt(*static_cast<const T*>(value)));
    }
    bool composeType(base::DataSourceBase::shared_ptr source, base::DataSourceBase::shared_ptr target) const override {
        if (const void* text = detail::valueOfType(source, typeid(std::string)))
            return fromString(*static_cast<const std::string*>(text), target);
        const void* number = detail::valueOfType(source, typeid(int));
        return number && set(target, fromInt(*static_cast<const int*>(number)));
    }
    std::vector<std::string> enumerators() const override {
        std::vector<std::string> names;
        for (const auto& known : to_string) names.push_back(known.second);
        return names;
    }
    /** True for all numbers, because the map may be incomplete. */
    bool takesNumber(long long) const override { return true; }

    std::ostream& write(std::ostream& os, base::DataSourceBase::shared_ptr source) const override {
        const void* value = detail::valueOfType(source, typeid(T));
        if (!value) return os;
        const std::string* text = textOf(*static_cast<const T*>(value));
        return text ? os << *text : os << toInt(*static_cast<const T*>(value));
    }
    std::istream& read(std::istream& is, base::DataSourceBase::shared_ptr target) const override {
        std::string text;
        if (is >> text && !fromString(text, target)) is.setstate(std::ios::failbit);
        return is;
    }
    /** By its text, or its number. */
    bool fromString(const std::string& text, base::DataSourceBase::shared_ptr target) const override {
        for (const auto& known : to_string)
            if (known.second == text) return set(target, known.first);
        int number = 0;
        return detail::readNumber(text, number) && set(target, fromInt(number));
    }
    bool isStreamable() const override { return true; }

protected:
    MapType to_string;

private:
    /** Null if it has none. */
    const std::string* textOf(T value) const {
        const auto known = to_string.find(value);
        return known == to_string.end() ? nullptr : &known->second;
    }
    static bool set(const base::DataSourceBase::shared_ptr& target, T value) {
        void* storage = detail::storageOfType(target, typeid(T));
        if (!storage) return false;
        *static_cast<T*>(storage) = value;
        target->updated();
        return true;
    }
    static T fromInt(int number) { return static_cast<T>(number); }
    static int toInt(T value) { return static_cast<int>(value); }
};

}  // namespace types
}  // namespace RTT

#endif
