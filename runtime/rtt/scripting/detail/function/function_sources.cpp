// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/function/function_sources.hpp>

#include <rtt/Logger.hpp>
#include <rtt/base/ActionInterface.hpp>
#include <rtt/base/AttributeBase.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <stdexcept>

namespace RTT::scripting::detail {

using base::DataSourceBase;

void FunctionUse::evaluateArguments() const {
    for (std::size_t i = 0; i != arguments.size(); ++i)
        if (!arguments[i]->evaluate())
            throw std::runtime_error("argument " + std::to_string(i + 1) + " of " + pool->owner()->describe() +
                                     " cannot be evaluated");
}

FunctionUse FunctionUse::copy(CopyMap& cloned) const {
    FunctionUse made{pool, {}, caller};
    for (const auto& argument : arguments) made.arguments.push_back(argument->copy(cloned));
    return made;
}

namespace {

/** Has its own execution, so that a call always finds one. */
class CallAction final : public base::ActionInterface {
public:
    CallAction(FunctionUse use, FunctionCall::shared_ptr call, DataSourceBase::shared_ptr result)
        : use_(std::move(use)), call_(std::move(call)), result_(std::move(result)) {}

    void readArguments() override { use_.evaluateArguments(); }
    bool execute() override {
        if (!call_->begin(use_.arguments))
            throw std::runtime_error(call_->owner().describe() + " is being executed for this caller already");
        call_->call(use_.caller.get());
        return !result_ || result_->assignValue(call_->result()->getRawConstPointer());
    }
    CallAction* clone() const override { return new CallAction(use_, use_.pool->take(), result_); }
    CallAction* copy(CopyMap& cloned) const override {
        return new CallAction(use_.copy(cloned), use_.pool->take(), result_ ? result_->copy(cloned) : nullptr);
    }

private:
    const FunctionUse use_;
    const FunctionCall::shared_ptr call_;
    const DataSourceBase::shared_ptr result_;
};

/** Of a function without result. */
template <class Void>
class VoidCallSource final : public internal::DataSource<Void> {
public:
    explicit VoidCallSource(CallAction* action) : action_(action) {}
    bool evaluate() const override {
        action_->readArguments();
        return action_->execute();
    }
    void get() const override { evaluate(); }
    void value() const override {}
    typename internal::DataSource<Void>::const_reference_t rvalue() const override {}
    VoidCallSource* clone() const override { return new VoidCallSource(action_->clone()); }
    VoidCallSource* copy(CopyMap& cloned) const override { return new VoidCallSource(action_->copy(cloned)); }

private:
    const std::unique_ptr<CallAction> action_;
};

class SendSource final : public FunctionHandle {
public:
    explicit SendSource(FunctionUse use) : use_(std::move(use)) {
        for (auto& call : calls_) call = use_.pool->take();
    }
    bool evaluate() const override { return get() != nullptr; }
    FunctionCall::shared_ptr get() const override {
        sent_.reset();
        use_.evaluateArguments();
        for (const auto& call : calls_)
            if (call->isUnused() && call->begin(use_.arguments)) {
                if (call->send(use_.caller.get())) sent_ = call;
                return sent_;
            }
        log(Error) << use_.pool->owner()->describe() << " is not sent: the last " << kCalls
                   << " calls are not done, or their handles are still in use" << endlog();
        return sent_;
    }
    FunctionCall::shared_ptr value() const override { return sent_; }
    const FunctionCall::shared_ptr& rvalue() const override { return sent_; }
    SendSource* clone() const override { return new SendSource(use_); }
    SendSource* copy(CopyMap& cloned) const override { return new SendSource(use_.copy(cloned)); }

private:
    static constexpr unsigned kCalls = 8;
    const FunctionUse use_;
    FunctionCall::shared_ptr calls_[kCalls];
    mutable FunctionCall::shared_ptr sent_;
};

class CollectSource final : public internal::DataSource<SendStatus> {
public:
    CollectSource(std::shared_ptr<FunctionOwner> owner, FunctionHandle::shared_ptr handle,
                  DataSourceBase::shared_ptr variable, internal::DataSource<bool>::shared_ptr blocking)
        : owner_(std::move(owner)),
          handle_(std::move(handle)),
          variable_(std::move(variable)),
          blocking_(std::move(blocking)) {}
    SendStatus get() const override {
        const FunctionCall::shared_ptr call = handle_->get();
        // A handle of another function may have a result of another type than the variable.
        if (!call || (variable_ && &call->owner() != owner_.get())) return status_ = SendFailure;
        status_ = call->collect(!blocking_ || blocking_->get());
        if (status_ == SendSuccess && variable_) {
            if (!variable_->assignValue(call->result()->getRawConstPointer())) return status_ = CollectFailure;
            variable_->updated();
        }
        return status_;
    }
    SendStatus value() const override { return status_; }
    const SendStatus& rvalue() const override { return status_; }
    CollectSource* clone() const override { return new CollectSource(owner_, handle_, variable_, blocking_); }
    CollectSource* copy(CopyMap& cloned) const override {
        return new CollectSource(owner_, handle_->copy(cloned), variable_ ? variable_->copy(cloned) : nullptr,
                                 blocking_ ? blocking_->copy(cloned) : nullptr);
    }

private:
    const std::shared_ptr<FunctionOwner> owner_;
    const FunctionHandle::shared_ptr handle_;
    const DataSourceBase::shared_ptr variable_;
    const internal::DataSource<bool>::shared_ptr blocking_;
    mutable SendStatus status_ = SendNotReady;
};

}  // namespace

DataSourceBase::shared_ptr makeCallSource(FunctionUse use) {
    FunctionCall::shared_ptr call = use.pool->take();
    if (!call->result()) return new VoidCallSource<void>(new CallAction(std::move(use), std::move(call), nullptr));
    const types::TypeInfo* const type = call->result()->getTypeInfo();
    // A variable as in programs, so that copies of the expression have their own results.
    const std::unique_ptr<base::AttributeBase> holder(type->buildVariable("result"));
    const DataSourceBase::shared_ptr result = holder->getDataSource();
    auto action = std::make_unique<CallAction>(std::move(use), std::move(call), result);
    const DataSourceBase::shared_ptr made = type->buildActionAlias(action.get(), result);
    if (!made) throw std::runtime_error("a result of type " + type->getTypeName() + " cannot be given to others");
    (void)action.release();
    return made;
}

FunctionHandle::shared_ptr makeSendSource(FunctionUse use) { return new SendSource(std::move(use)); }

DataSourceBase::shared_ptr makeCollectSource(std::shared_ptr<FunctionOwner> owner, FunctionHandle::shared_ptr handle,
                                             DataSourceBase::shared_ptr variable,
                                             internal::DataSource<bool>::shared_ptr blocking) {
    return new CollectSource(std::move(owner), std::move(handle), std::move(variable), std::move(blocking));
}

}  // namespace RTT::scripting::detail
