// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The type information of enums that are described by a table of their enumerators.
#include <rtt/types/StructTable.hpp>

#include <rtt/internal/DataSources.hpp>
#include <rtt/types/CompositionFactory.hpp>
#include <rtt/types/StreamFactory.hpp>
#include <rtt/types/TypeOps.hpp>
#include "enum_constructors.hpp"
#include "table_generator.hpp"
#include <cstdlib>
#include <istream>
#include <ostream>

namespace RTT {
namespace types {
namespace detail {

using base::DataSourceBase;

namespace {

class EnumTable : public TableGenerator, public CompositionFactory, public StreamFactory {
public:
    EnumTable(const char* name, const Enumerator* values, std::size_t count, const char* doc, const TypeOps& ops,
              const TypeThunks& thunks, const EnumOps& numbers, TypeRef type)
        : TableGenerator(name, doc, ops, thunks), values_(values), count_(count), numbers_(numbers), type_(type) {}

    bool installTypeInfoObject(TypeInfo* info) override {
        TableGenerator::installTypeInfoObject(info);
        const auto self = boost::static_pointer_cast<EnumTable>(getSharedPtr());
        info->setCompositionFactory(self);
        info->setStreamFactory(self);
        addEnumConstructors(*info, type_, numbers_);
        return false;
    }

    /** On disk an enum is its enumerator's name; a value without one is its number. */
    DataSourceBase::shared_ptr decomposeType(DataSourceBase::shared_ptr source) const override {
        const void* value = valueOfType(source, *ops().id);
        return value ? new internal::ValueDataSource<std::string>(textOf(value)) : nullptr;
    }
    bool composeType(DataSourceBase::shared_ptr source, DataSourceBase::shared_ptr target) const override {
        if (const void* text = valueOfType(source, typeid(std::string)))
            return fromString(*static_cast<const std::string*>(text), target);
        if (const void* number = valueOfType(source, typeid(int)))
            return setNumber(target, *static_cast<const int*>(number));
        return false;
    }

    std::ostream& write(std::ostream& os, DataSourceBase::shared_ptr source) const override {
        if (const void* value = valueOfType(source, *ops().id)) os << textOf(value);
        return os;
    }
    std::istream& read(std::istream& is, DataSourceBase::shared_ptr target) const override {
        std::string text;
        if (is >> text && !fromString(text, target)) is.setstate(std::ios::failbit);
        return is;
    }
    bool fromString(const std::string& text, DataSourceBase::shared_ptr target) const override {
        for (std::size_t i = 0; i != count_; ++i)
            if (text == values_[i].name) return setNumber(target, values_[i].value);
        char* end = nullptr;
        const long long number = numbers_.isUnsigned ? static_cast<long long>(std::strtoull(text.c_str(), &end, 10))
                                                     : std::strtoll(text.c_str(), &end, 10);
        return end != text.c_str() && *end == '\0' && setNumber(target, number);
    }
    bool isStreamable() const override { return true; }

private:
    std::string textOf(const void* value) const {
        const long long number = numbers_.get(value);
        for (std::size_t i = 0; i != count_; ++i)
            if (values_[i].value == number) return values_[i].name;
        return numbers_.isUnsigned ? std::to_string(static_cast<unsigned long long>(number)) : std::to_string(number);
    }
    bool setNumber(const DataSourceBase::shared_ptr& target, long long number) const {
        void* storage = storageOfType(target, *ops().id);
        if (!storage) return false;
        numbers_.set(storage, number);
        target->updated();
        return true;
    }

    const Enumerator* values_;
    std::size_t count_;
    const EnumOps& numbers_;
    TypeRef type_;
};

}  // namespace

TypeInfoGenerator* newEnumGenerator(const char* name, const Enumerator* values, std::size_t count, const char* doc,
                                    const TypeOps& ops, const TypeThunks& thunks, const EnumOps& enumOps,
                                    TypeRef type) {
    return new EnumTable(name, values, count, doc, ops, thunks, enumOps, type);
}

}  // namespace detail
}  // namespace types
}  // namespace RTT
