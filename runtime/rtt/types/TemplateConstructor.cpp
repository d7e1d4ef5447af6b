// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "TemplateConstructor.hpp"

namespace RTT::types::detail {

namespace {

class ErasedConstructor : public TypeConstructor {
public:
    ErasedConstructor(const ErasedFunction& function, bool automatic) : function_(function), automatic_(automatic) {}

    base::DataSourceBase::shared_ptr build(
        const std::vector<base::DataSourceBase::shared_ptr>& arguments) const override {
        if (arguments.size() != function_.arity) return nullptr;
        // A constructor with a single argument is a conversion, and conversions are not chained.
        if (arguments.size() < 2) return function_.apply(arguments);
        std::vector<base::DataSourceBase::shared_ptr> converted;
        for (std::size_t i = 0; i != arguments.size(); ++i) {
            const TypeInfo* wanted = Types()->getTypeById(function_.arguments[i]());
            converted.push_back(wanted ? wanted->convert(arguments[i]) : arguments[i]);
        }
        return function_.apply(converted);
    }
    base::DataSourceBase::shared_ptr convert(base::DataSourceBase::shared_ptr argument) const override {
        if (function_.arity != 1) return nullptr;
        auto made = function_.apply({argument});
        if (made && !automatic_) warnConversion(*argument, *made);
        return made;
    }

private:
    ErasedFunction function_;
    bool automatic_;
};

}  // namespace

TypeConstructor* newErasedConstructor(const ErasedFunction& function, bool automatic) {
    return new ErasedConstructor(function, automatic);
}

}  // namespace RTT::types::detail
