// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/types/SequenceMembers.hpp>

#include <rtt/Attribute.hpp>
#include <rtt/base/ActionInterface.hpp>
#include <rtt/types/SizeLimit.hpp>
#include <rtt/types/TypeConstructor.hpp>
#include <rtt/types/TypeThunkTable.hpp>
#include <cstring>
#include <memory>
#include <stdexcept>

namespace RTT::types::detail {

using base::DataSourceBase;
using SourcePtr = DataSourceBase::shared_ptr;
using Arguments = std::vector<SourcePtr>;

namespace {

bool holds(const SourcePtr& source, const char* idName) {
    return source && source->getTypeId() && std::strcmp(source->getTypeId()->name(), idName) == 0;
}

/** Fills the result each time the constructed value is evaluated. */
class FillAction : public base::ActionInterface {
public:
    enum class Kind { elements, size };

    FillAction(const SequenceOps& ops, Kind kind, Arguments arguments, SourcePtr result)
        : ops_(ops), kind_(kind), arguments_(std::move(arguments)), result_(std::move(result)) {}

    void readArguments() override {
        ready_ = true;
        for (const auto& argument : arguments_) ready_ = argument->evaluate() && ready_;
    }
    bool execute() override { return ready_ && (kind_ == Kind::elements ? fillElements() : fillSize()); }
    ActionInterface* clone() const override { return new FillAction(ops_, kind_, arguments_, result_); }
    ActionInterface* copy(std::map<const DataSourceBase*, DataSourceBase*>& cloned) const override {
        Arguments arguments;
        for (const auto& argument : arguments_) arguments.push_back(argument->copy(cloned));
        return new FillAction(ops_, kind_, std::move(arguments), result_->copy(cloned));
    }

private:
    bool fillElements() {
        void* container = result_->getRawPointer();
        if (!ops_.resize(container, ops_.insert ? 0 : arguments_.size())) return false;
        if (ops_.insert) {
            for (const SourcePtr& argument : arguments_) ops_.insert(container, argument->getRawConstPointer());
            return true;
        }
        for (std::size_t i = 0; i != arguments_.size(); ++i)
            ops_.store(container, i, arguments_[i]->getRawConstPointer());
        return true;
    }
    bool fillSize() {
        void* container = result_->getRawPointer();
        const int size = *static_cast<const int*>(arguments_[0]->getRawConstPointer());
        if (size > 0 && !isWithinSizeLimit(static_cast<std::size_t>(size)))
            throw std::length_error("there can be no value with " + beyondSizeLimit(static_cast<std::size_t>(size)));
        // First to zero, so that no element of an earlier evaluation survives.
        if (size < 0 || !ops_.resize(container, 0) || !ops_.resize(container, static_cast<std::size_t>(size)))
            return false;
        for (int i = 0; arguments_.size() == 2 && i != size; ++i)
            ops_.store(container, static_cast<std::size_t>(i), arguments_[1]->getRawConstPointer());
        return true;
    }

    const SequenceOps& ops_;
    Kind kind_;
    Arguments arguments_;
    SourcePtr result_;
    bool ready_ = false;
};

class SequenceConstructor : public TypeConstructor {
public:
    SequenceConstructor(const SequenceOps& ops, const TypeThunks& thunks) : ops_(ops), thunks_(thunks) {}

    SourcePtr build(const Arguments& arguments) const override {
        if (arguments.empty() || !ops_.resize) return nullptr;
        if (areElements(arguments)) return make(FillAction::Kind::elements, arguments);
        const bool withSize = holds(arguments[0], typeid(int).name());
        if (withSize && arguments.size() == 1) return make(FillAction::Kind::size, arguments);
        if (withSize && arguments.size() == 2 && holds(arguments[1], ops_.elementType()))
            return make(FillAction::Kind::size, arguments);
        return nullptr;
    }

private:
    bool areElements(const Arguments& arguments) const {
        for (const auto& argument : arguments)
            if (!holds(argument, ops_.elementType())) return false;
        return true;
    }
    SourcePtr make(FillAction::Kind kind, const Arguments& arguments) const {
        const std::unique_ptr<base::AttributeBase> holder(thunks_.variable("", 0));
        const SourcePtr storage = holder->getDataSource();
        auto action = std::make_unique<FillAction>(ops_, kind, arguments, storage);
        SourcePtr made = thunks_.actionAlias(action.get(), storage.get());
        if (made) (void)action.release();
        return made;
    }

    const SequenceOps& ops_;
    const TypeThunks& thunks_;
};

}  // namespace

TypeConstructor* newSequenceConstructor(const SequenceOps& sequence, const TypeThunks& thunks) {
    return new SequenceConstructor(sequence, thunks);
}

}  // namespace RTT::types::detail
