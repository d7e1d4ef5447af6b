// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "ErasedFunction.hpp"

#include <rtt/Attribute.hpp>
#include <rtt/Logger.hpp>
#include <rtt/base/ActionInterface.hpp>
#include "TypeThunkTable.hpp"
#include "Types.hpp"
#include <cstring>
#include <exception>

namespace RTT::types {

using base::DataSourceBase;

namespace {

/** Writes the function's result into `result_`, which the source that owns this action then shows. */
class ComputeAction : public base::ActionInterface {
public:
    ComputeAction(const ErasedFunction& function, std::vector<DataSourceBase::shared_ptr> arguments,
                  DataSourceBase::shared_ptr result)
        : function_(function), arguments_(std::move(arguments)), result_(std::move(result)) {}

    void readArguments() override {
        ready_ = true;
        for (std::size_t i = 0; i != arguments_.size(); ++i) {
            ready_ = arguments_[i]->evaluate() && ready_;
            values_[i] = arguments_[i]->getRawConstPointer();
        }
    }
    bool execute() override {
        if (!ready_) return false;
        try {
            return function_.call(function_.context.get(), values_.data(), result_->getRawPointer());
        } catch (const std::exception& reason) {
            log(Error) << "no value of type " << result_->getTypeName() << ": " << reason.what() << endlog();
            return false;
        }
    }
    ActionInterface* clone() const override { return new ComputeAction(function_, arguments_, result_); }
    ActionInterface* copy(std::map<const DataSourceBase*, DataSourceBase*>& cloned) const override {
        std::vector<DataSourceBase::shared_ptr> arguments;
        for (const auto& argument : arguments_) arguments.push_back(argument->copy(cloned));
        return new ComputeAction(function_, std::move(arguments), result_->copy(cloned));
    }

private:
    ErasedFunction function_;
    std::vector<DataSourceBase::shared_ptr> arguments_;
    std::array<const void*, ErasedFunction::maxArity> values_{};
    DataSourceBase::shared_ptr result_;
    bool ready_ = false;
};

}  // namespace

bool ErasedFunction::accepts(std::size_t position, const DataSourceBase& argument) const {
    const std::type_info* id = argument.getTypeId();
    return id && position < arity && std::strcmp(id->name(), arguments[position]()) == 0;
}

DataSourceBase::shared_ptr ErasedFunction::apply(const std::vector<DataSourceBase::shared_ptr>& given) const {
    if (given.size() != arity) return nullptr;
    for (std::size_t i = 0; i != arity; ++i)
        if (!given[i] || !accepts(i, *given[i])) return nullptr;
    const TypeInfo* type = Types()->getTypeById(result());
    const TypeThunks* thunks = type ? type->getThunks() : nullptr;
    if (!thunks || !thunks->variable || !thunks->actionAlias) return nullptr;
    // A variable as in programs, so that copies of the expression have their own results.
    const std::unique_ptr<base::AttributeBase> holder(thunks->variable("", 0));
    const DataSourceBase::shared_ptr storage = holder->getDataSource();
    auto action = std::make_unique<ComputeAction>(*this, given, storage);
    DataSourceBase::shared_ptr made = thunks->actionAlias(action.get(), storage.get());
    if (made) (void)action.release();
    return made;
}

}  // namespace RTT::types
