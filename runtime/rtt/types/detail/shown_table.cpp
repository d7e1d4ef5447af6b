// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The type information of types whose values are shown, read and stored as those of another type.
#include <rtt/types/ShownTable.hpp>

#include <rtt/types/CompositionFactory.hpp>
#include <rtt/types/Shape.hpp>
#include <rtt/types/StreamFactory.hpp>
#include <rtt/types/TemplateConstructor.hpp>
#include <rtt/types/TypeOps.hpp>
#include <rtt/types/TypeThunkTable.hpp>
#include "table_generator.hpp"
#include <cstdio>
#include <cstdlib>
#include <istream>
#include <limits>
#include <memory>
#include <ostream>

namespace RTT::types::detail {

using base::DataSourceBase;
using SourcePtr = DataSourceBase::shared_ptr;

namespace {

bool convertToShown(const void* shown, const void* const* arguments, void* result) {
    static_cast<const ShownAs*>(shown)->show(arguments[0], result);
    return true;
}

bool convertFromShown(const void* shown, const void* const* arguments, void* result) {
    return static_cast<const ShownAs*>(shown)->take(arguments[0], result);
}

TypeConstructor* newConversion(ComputeFunction call, const ShownAs& shown, TypeRef result, TypeRef argument) {
    ErasedFunction function;
    function.call = call;
    function.context = std::shared_ptr<const void>(&shown, [](const void*) {});
    function.result = result;
    function.arity = 1;
    function.arguments = {argument};
    return newErasedConstructor(function, true);
}

class ShownTable : public TableGenerator, public CompositionFactory, public StreamFactory, public HasShape {
public:
    ShownTable(const char* name, const char* doc, TypeRef self, const TypeOps& ops, const TypeThunks& thunks,
               const ShownAs& shown)
        : TableGenerator(name, doc, ops, thunks), self_(self), shown_(shown) {}

    bool installTypeInfoObject(TypeInfo* info) override {
        TableGenerator::installTypeInfoObject(info);
        const auto self = boost::static_pointer_cast<ShownTable>(getSharedPtr());
        info->setCompositionFactory(self);
        info->setStreamFactory(self);
        for (const ShownAs* shown = &shown_; shown; shown = shown->also) {
            info->addConstructor(newConversion(&convertFromShown, *shown, self_, shown->type));
            if (TypeInfo* const other = Types()->getTypeById(shown->type()))
                other->addConstructor(newConversion(&convertToShown, *shown, shown->type, self_));
        }
        return false;
    }

    Shape shape() const override {
        Shape shape;
        shape.kind = Shape::Kind::Shown;
        shape.shown = &shown_;
        return shape;
    }
    SourcePtr decomposeType(SourcePtr source) const override {
        const void* const value = valueOfType(source, *ops().id);
        const SourcePtr result = value ? newShown() : nullptr;
        if (result) shown_.show(value, result->getRawPointer());
        return result;
    }
    bool composeType(SourcePtr source, SourcePtr target) const override {
        for (const ShownAs* shown = &shown_; shown; shown = shown->also) {
            const TypeInfo* const type = Types()->getTypeById(shown->type());
            const SourcePtr converted = type && type->getTypeId() ? type->convert(source) : nullptr;
            const void* const value = converted ? valueOfType(converted, *type->getTypeId()) : nullptr;
            if (value && take(*shown, value, target)) return true;
        }
        return false;
    }
    std::ostream& write(std::ostream& os, SourcePtr source) const override {
        const SourcePtr result = decomposeType(source);
        return result ? result->write(os) : os;
    }
    std::istream& read(std::istream& is, SourcePtr target) const override {
        const SourcePtr value = newShown();
        if (!value || !value->getTypeInfo()->read(is, value) || !take(shown_, value->getRawConstPointer(), target))
            is.setstate(std::ios::failbit);
        return is;
    }
    bool isStreamable() const override { return true; }

private:
    SourcePtr newShown() const {
        const TypeInfo* const type = Types()->getTypeById(shown_.type());
        return type ? type->buildValue() : nullptr;
    }
    bool take(const ShownAs& shown, const void* value, const SourcePtr& target) const {
        void* const storage = storageOfType(target, *ops().id);
        if (!storage || !shown.take(value, storage)) return false;
        target->updated();
        return true;
    }

    TypeRef self_;
    const ShownAs& shown_;
};

}  // namespace

std::string textOf(long double number) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*Lg", std::numeric_limits<long double>::max_digits10, number);
    return text;
}

bool fromText(const std::string& text, long double& number) {
    char* end = nullptr;
    const long double read = std::strtold(text.c_str(), &end);
    if (text.empty() || *end != '\0') return false;
    number = read;
    return true;
}

TypeInfoGenerator* newShownGenerator(const char* name, const char* doc, TypeRef self, const TypeOps& ops,
                                     const TypeThunks& thunks, const ShownAs& shown) {
    return new ShownTable(name, doc, self, ops, thunks, shown);
}

}  // namespace RTT::types::detail
