// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The type information of enums that are described by a table of their enumerators.
#include <rtt/types/StructTable.hpp>

#include <rtt/internal/DataSources.hpp>
#include <rtt/types/CompositionFactory.hpp>
#include <rtt/types/Shape.hpp>
#include <rtt/types/StreamFactory.hpp>
#include <rtt/types/TypeOps.hpp>
#include "enum_constructors.hpp"
#include "table_generator.hpp"
#include <istream>
#include <ostream>

namespace RTT::types::detail {

using base::DataSourceBase;

namespace {

class EnumTable : public TableGenerator,
                  public CompositionFactory,
                  public Enumeration,
                  public StreamFactory,
                  public HasShape {
public:
    EnumTable(const char* name, const Enumerator* values, std::size_t count, const char* doc, const TypeOps& ops,
              const TypeThunks& thunks, const EnumOps& numbers, TypeRef type)
        : TableGenerator(name, doc, ops, thunks), names_{values, count, numbers}, type_(type) {}

    bool installTypeInfoObject(TypeInfo* info) override {
        TableGenerator::installTypeInfoObject(info);
        const auto self = boost::static_pointer_cast<EnumTable>(getSharedPtr());
        info->setCompositionFactory(self);
        info->setStreamFactory(self);
        addEnumConstructors(*info, type_, names_);
        return false;
    }

    Shape shape() const override {
        Shape shape;
        shape.kind = Shape::Kind::Enumeration;
        shape.numbers = &names_.ops;
        for (std::size_t i = 0; i != names_.count; ++i)
            shape.enumerators.push_back(
                {names_.values[i].name, names_.values[i].value, names_.values[i].doc ? names_.values[i].doc : ""});
        return shape;
    }

    /** Files store the enumerator's name; a value without one as its number, or as text if that does not fit into an
        int. */
    DataSourceBase::shared_ptr decomposeType(DataSourceBase::shared_ptr source) const override {
        const void* value = valueOfType(source, *ops().id);
        if (!value) return nullptr;
        const std::string text = names_.textOf(value);
        int number = 0;
        if (names_.nameOf(value) || !readNumber(text, number)) return new internal::ValueDataSource<std::string>(text);
        return new internal::ValueDataSource<int>(number);
    }
    bool composeType(DataSourceBase::shared_ptr source, DataSourceBase::shared_ptr target) const override {
        if (const void* text = valueOfType(source, typeid(std::string)))
            return fromString(*static_cast<const std::string*>(text), target);
        if (const void* number = valueOfType(source, typeid(int)))
            return setNumber(target, *static_cast<const int*>(number));
        return false;
    }
    std::vector<std::string> enumerators() const override {
        std::vector<std::string> names;
        for (std::size_t i = 0; i != names_.count; ++i) names.emplace_back(names_.values[i].name);
        return names;
    }
    bool takesNumber(long long number) const override { return names_.takes(number); }

    std::ostream& write(std::ostream& os, DataSourceBase::shared_ptr source) const override {
        if (const void* value = valueOfType(source, *ops().id)) os << names_.textOf(value);
        return os;
    }
    std::istream& read(std::istream& is, DataSourceBase::shared_ptr target) const override {
        std::string text;
        if (is >> text && !fromString(text, target)) is.setstate(std::ios::failbit);
        return is;
    }
    bool fromString(const std::string& text, DataSourceBase::shared_ptr target) const override {
        void* const storage = storageOfType(target, *ops().id);
        if (!storage || !names_.set(text, storage)) return false;
        target->updated();
        return true;
    }
    bool isStreamable() const override { return true; }

private:
    bool setNumber(const DataSourceBase::shared_ptr& target, long long number) const {
        void* storage = storageOfType(target, *ops().id);
        if (!storage) return false;
        names_.ops.set(storage, number);
        target->updated();
        return true;
    }

    const EnumNames names_;
    TypeRef type_;
};

}  // namespace

TypeInfoGenerator* newEnumGenerator(const char* name, const Enumerator* values, std::size_t count, const char* doc,
                                    const TypeOps& ops, const TypeThunks& thunks, const EnumOps& enumOps,
                                    TypeRef type) {
    return new EnumTable(name, values, count, doc, ops, thunks, enumOps, type);
}

}  // namespace RTT::types::detail
