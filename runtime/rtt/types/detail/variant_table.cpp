// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The type information of std::variant: a struct of the alternative's name and its value.
#include <rtt/types/VariantTable.hpp>

#include <rtt/Logger.hpp>
#include <rtt/PropertyBag.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/types/CompositionFactory.hpp>
#include <rtt/types/MemberFactory.hpp>
#include <rtt/types/Shape.hpp>
#include <rtt/types/StreamFactory.hpp>
#include <rtt/types/TypeOps.hpp>
#include <rtt/types/TypeThunkTable.hpp>
#include <rtt/types/Types.hpp>
#include <rtt/types/member_update.hpp>
#include "table_generator.hpp"
#include <istream>
#include <ostream>

namespace RTT::types::detail {

using base::DataSourceBase;
using SourcePtr = DataSourceBase::shared_ptr;

namespace {

/** The alternatives of a variant type. */
struct Choice {
    const char* const* names;
    const VariantOps& ops;

    /** ops.count if there is none of that name. */
    std::size_t find(const std::string& name) const {
        std::size_t i = 0;
        while (i != ops.count && name != names[i]) ++i;
        return i;
    }
    std::string nameAt(std::size_t index) const { return index < ops.count ? names[index] : ""; }
    /** Null for alternatives without a value, such as std::monostate. */
    const TypeThunks* thunksAt(std::size_t index) const {
        const TypeInfo* const type = index < ops.count ? Types()->getTypeById(ops.types[index]()) : nullptr;
        return type ? type->getThunks() : nullptr;
    }
    SourcePtr elementAt(const SourcePtr& variant, std::size_t index) const {
        const TypeThunks* const thunks = thunksAt(index);
        if (!thunks || !thunks->element) return nullptr;
        auto* const which = new internal::ConstantDataSource<unsigned int>(static_cast<unsigned int>(index));
        return thunks->element(variant.get(), which, &ops.elements);
    }
    /** Changes the variant to the alternative of that name, with a default value; no change if it has that already. */
    bool choose(void* variant, const std::string& name) const {
        const std::size_t index = find(name);
        if (index == ops.count) return false;
        if (index != ops.index(variant)) ops.choose(variant, index);
        return true;
    }
};

/** The name of the alternative that a variant holds; assigning another name changes the alternative. */
class AlternativeDataSource : public internal::AssignableDataSource<std::string> {
public:
    AlternativeDataSource(SourcePtr variant, const Choice& choice) : variant_(std::move(variant)), choice_(choice) {}

    std::string get() const override { return variant_->evaluate() ? rvalue() : std::string(); }
    std::string value() const override { return rvalue(); }
    const std::string& rvalue() const override {
        const void* const at = variant_->getRawConstPointer();
        return name_ = at ? choice_.nameAt(choice_.ops.index(at)) : "";
    }
    bool evaluate() const override { return variant_->evaluate(); }
    void set(param_t name) override {
        name_ = name;
        updated();
    }
    std::string& set() override {
        rvalue();
        return name_;
    }
    void updated() override {
        void* const at = variant_->getRawPointer();
        if (at && choice_.choose(at, name_))
            variant_->updated();
        else
            log(Error) << "type " << variant_->getTypeName() << " has no alternative " << name_ << endlog();
    }
    bool isAssignable() const override { return variant_->isAssignable(); }
    SourcePtr getParent() override { return variant_; }
    AlternativeDataSource* clone() const override { return new AlternativeDataSource(variant_, choice_); }
    AlternativeDataSource* copy(internal::CopyMap& cloned) const override {
        return new AlternativeDataSource(variant_->copy(cloned), choice_);
    }

private:
    SourcePtr variant_;
    Choice choice_;
    mutable std::string name_;
};

class VariantTable : public TableGenerator,
                     public MemberFactory,
                     public CompositionFactory,
                     public StreamFactory,
                     public HasShape {
public:
    VariantTable(const char* name, const char* const* names, const VariantOps& variant, const TypeOps& ops,
                 const TypeThunks& thunks)
        : TableGenerator(name, "", ops, thunks), choice_{names, variant} {}

    bool installTypeInfoObject(TypeInfo* info) override {
        TableGenerator::installTypeInfoObject(info);
        const auto self = boost::static_pointer_cast<VariantTable>(getSharedPtr());
        info->setMemberFactory(self);
        info->setCompositionFactory(self);
        info->setStreamFactory(self);
        return false;
    }

    Shape shape() const override {
        Shape shape;
        shape.kind = Shape::Kind::Variant;
        shape.variant = &choice_.ops;
        for (std::size_t i = 0; i != choice_.ops.count; ++i)
            shape.fields.push_back({choice_.names[i], 0, choice_.ops.types[i](), 0, nullptr});
        return shape;
    }
    std::vector<std::string> getMemberNames() const override { return {"alternative", "value"}; }
    using MemberFactory::getMember;
    /** Also finds alternatives by name; storing a value in one changes the variant to it. */
    SourcePtr getMember(SourcePtr item, const std::string& name) const override {
        if (name == "alternative") return new AlternativeDataSource(item, choice_);
        if (name == "value") return valueOf(item);
        return choice_.elementAt(item, choice_.find(name));
    }

    SourcePtr decomposeType(SourcePtr source) const override {
        const void* const variant = valueOfType(source, *ops().id);
        if (!variant) return nullptr;
        boost::intrusive_ptr<internal::ValueDataSource<PropertyBag>> result(
            new internal::ValueDataSource<PropertyBag>());
        PropertyBag& bag = result->set();
        bag.setType(source->getTypeName());
        bag.ownProperty(new Property<std::string>("alternative", "Name of the value's type.",
                                                  choice_.nameAt(choice_.ops.index(variant))));
        if (const SourcePtr value = valueOf(source))
            bag.ownProperty(value->getTypeInfo()->buildProperty("value", "Part", value));
        return result;
    }
    bool composeType(SourcePtr source, SourcePtr target) const override {
        const auto* const bag = static_cast<const PropertyBag*>(valueOfType(source, typeid(PropertyBag)));
        void* const variant = bag ? storageOfType(target, *ops().id) : nullptr;
        if (!variant) return false;
        const base::PropertyBase* const name = bag->find("alternative");
        const void* const text = name ? valueOfType(name->getDataSource(), typeid(std::string)) : nullptr;
        if (text && !choice_.choose(variant, *static_cast<const std::string*>(text))) {
            log(Error) << "type " << target->getTypeName() << " has no alternative "
                       << *static_cast<const std::string*>(text) << endlog();
            return false;
        }
        const base::PropertyBase* const value = bag->find("value");
        const SourcePtr element = value ? valueOf(target) : nullptr;
        if (element && !updateWithConversion(element, value->getDataSource())) {
            log(Error) << "the alternative " << choice_.nameAt(choice_.ops.index(variant)) << " of type "
                       << target->getTypeName() << " cannot take a value of type " << value->getType() << endlog();
            return false;
        }
        target->updated();
        return true;
    }

    std::ostream& write(std::ostream& os, SourcePtr source) const override {
        const void* const variant = valueOfType(source, *ops().id);
        os << "{alternative = " << (variant ? choice_.nameAt(choice_.ops.index(variant)) : "");
        const SourcePtr value = variant ? valueOf(source) : nullptr;
        if (value && value->evaluate()) value->write(os << ", value = ");
        return os << '}';
    }
    std::istream& read(std::istream& is, SourcePtr) const override {
        is.setstate(std::ios::failbit);
        return is;
    }
    bool isStreamable() const override { return false; }

private:
    SourcePtr valueOf(const SourcePtr& item) const {
        const void* const variant = valueOfType(item, *ops().id);
        return variant ? choice_.elementAt(item, choice_.ops.index(variant)) : nullptr;
    }

    Choice choice_;
};

}  // namespace

TypeInfoGenerator* newVariantGenerator(const char* name, const char* const* names, const VariantOps& variant,
                                       const TypeOps& ops, const TypeThunks& thunks) {
    return new VariantTable(name, names, variant, ops, thunks);
}

}  // namespace RTT::types::detail
