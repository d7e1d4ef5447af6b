// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/calls/remote_operation.hpp>

#include <rtt/Logger.hpp>
#include <rtt/internal/calls/detail/part_send.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/TypeInfoRepository.hpp>

#include <boost/core/demangle.hpp>

#include <exception>

namespace RTT::internal {

namespace {

using detail::CallerSources;
using detail::Source;

/** The sources of a call. */
struct Prepared {
    Prepared(const OperationInterfacePart& part, const CallerSignature& signature, ExecutionEngine* engine)
        : values(signature), caller(engine) {
        const Source call = part.produce(values.arguments(), engine);
        if (!call) throw std::runtime_error("it offers no way to call it");
        values.expectFrom(call);
    }
    void make(void* const* arguments, void* result, const OperationInterfacePart& part) {
        values.take(arguments, result);
        switch (values.execute()) {
            case detail::Outcome::done: return values.give(arguments, result);
            case detail::Outcome::notExecuted:
                throw SendError(SendFailure, "operation '" + part.getName() + "' was not executed");
            case detail::Outcome::notConverted:
                throw std::runtime_error("operation '" + part.getName() +
                                         "' was executed, but its result could not be converted");
        }
    }
    CallerSources values;
    ExecutionEngine* const caller;
};

/** Releases the prepared call at the end. */
struct Claim {
    std::atomic<bool>& busy;
    const bool mine;
    // Acquire: pairs with the release below, so that the next claim sees the call as this one left it.
    explicit Claim(std::atomic<bool>& flag) : busy(flag), mine(!flag.exchange(true, std::memory_order_acquire)) {}
    ~Claim() {
        if (mine) busy.store(false, std::memory_order_release);
    }
};

/** A copy: unlike the component's own caller it does not forget the component. */
base::OperationCallerInterface::shared_ptr localOf(const OperationInterfacePart& part) {
    const base::DisposableInterface::shared_ptr held = part.getLocalOperation();
    const auto* const local = dynamic_cast<const base::OperationCallerInterface*>(held.get());
    return base::OperationCallerInterface::shared_ptr(local ? local->cloneFor(nullptr) : nullptr);
}

/** An operation as seen by a caller with a certain signature. */
class RemoteOperation final : public base::OperationCallerInterface {
public:
    RemoteOperation(OperationInterfacePart::shared_constptr part, const CallerSignature& s, ExecutionEngine* caller)
        : signature(s),
          part_(std::move(part)),
          local_(localOf(*part_)),
          prepared_(std::make_unique<Prepared>(*part_, s, caller)) {
        setCaller(caller);
    }
    bool ready() const override { return !local_ || local_->ready(); }
    RemoteOperation* cloneI(ExecutionEngine* caller) const override {
        return new RemoteOperation(part_, signature, caller);
    }
    void call(void* const* arguments, void* result) {
        const Claim claim(busy_);
        if (!claim.mine) return Prepared(*part_, signature, getCaller()).make(arguments, result, *part_);
        if (prepared_->caller != getCaller()) prepared_ = std::make_unique<Prepared>(*part_, signature, getCaller());
        prepared_->make(arguments, result, *part_);
    }
    bool send(SentCall& call, void* const* arguments, void* result) {
        try {
            auto sent = detail::PartSend::make(*part_, signature, getCaller(), arguments, result);
            if (!sent) return false;
            call.collectFrom(std::move(sent));
            return true;
        } catch (const std::exception& e) {
            log(Error) << "operation '" << part_->getName() << "' cannot be sent: " << e.what() << endlog();
            return false;
        }
    }
    const OperationInterfacePart* part() const { return part_.get(); }
    const CallerSignature& signature;

private:
    const OperationInterfacePart::shared_constptr part_;
    const base::OperationCallerInterface::shared_ptr local_;  // null if the component is in another process
    std::unique_ptr<Prepared> prepared_;
    std::atomic<bool> busy_{false};  // a thread uses prepared_
};

std::string signatureOf(const OperationInterfacePart& part) {
    std::string text = part.resultType() + " (";
    const char* separator = "";
    for (const ArgumentDescription& argument : part.getArgumentList()) {
        text += separator + argument.type;
        separator = ", ";
    }
    return text + ")";
}

/** As signatureOf(part) writes it; a type that no typekit knows has its C++ name. */
std::string nameOf(const CallerValue& value) {
    const types::TypeInfo* const known = types::TypeInfoRepository::Instance()->getTypeById(value.type);
    const std::string name = known ? known->getTypeName() : boost::core::demangle(value.type->name());
    return name + (value.isOutput ? "&" : value.isConstant ? " const&" : "");
}

std::string signatureOf(const CallerSignature& signature) {
    std::string text = nameOf(signature.values[0]) + " (";
    for (unsigned i = 1; i <= signature.arity; ++i) text += (i > 1 ? ", " : "") + nameOf(signature.values[i]);
    return text + ")";
}

}  // namespace

base::OperationCallerInterface* makeRemoteOperation(const OperationInterfacePart* part,
                                                    const CallerSignature& signature, ExecutionEngine* caller) {
    try {
        detail::checkOutputs(*part, signature);
        return new RemoteOperation(OperationInterfacePart::hold(part), signature, caller);
    } catch (const std::exception& e) {
        log(Error) << "operation '" << part->getName() << "' is " << signatureOf(*part) << " and cannot be called as "
                   << signatureOf(signature) << ": " << e.what() << endlog();
        return nullptr;
    }
}

base::OperationCallerInterface* copyRemoteOperation(const base::DisposableInterface& held,
                                                    const CallerSignature& signature, ExecutionEngine* caller,
                                                    const std::string& name) {
    const auto* const remote = dynamic_cast<const RemoteOperation*>(&held);
    if (remote && *remote->signature.type == *signature.type)
        return makeRemoteOperation(remote->part(), signature, caller);
    log(Error) << "operation '" << name << "' cannot be called as " << signatureOf(signature)
               << ": what was given for it is a "
               << (remote ? signatureOf(remote->signature) : boost::core::demangle(typeid(held).name())) << endlog();
    return nullptr;
}

void callRemoteOperation(const base::OperationCallerInterface::shared_ptr& held, void* const* arguments, void* result) {
    // While the call waits, a message may bind the caller to another operation.
    const base::OperationCallerInterface::shared_ptr kept = held;
    auto* const remote = dynamic_cast<RemoteOperation*>(kept.get());
    if (remote && remote->ready()) remote->call(arguments, result);
}

bool sendRemoteOperation(const base::OperationCallerInterface::shared_ptr& held, SentCall& call, unsigned arity,
                         void* result) {
    const base::OperationCallerInterface::shared_ptr kept = held;
    auto* const remote = dynamic_cast<RemoteOperation*>(kept.get());
    if (!remote || !remote->ready()) return false;
    std::vector<void*> arguments;
    for (unsigned i = 0; i != arity; ++i) arguments.push_back(call.argumentAddress(i));
    arguments.push_back(nullptr);
    return remote->send(call, arguments.data(), result);
}

}  // namespace RTT::internal
