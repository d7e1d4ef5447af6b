// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/remote_part.hpp>

#include <rtt/FactoryExceptions.hpp>
#include <rtt/SendStatus.hpp>
#include <rtt/base/ActionInterface.hpp>
#include <rtt/base/AttributeBase.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/transports/corba/detail/any_values.hpp>
#include <rtt/transports/corba/detail/call_arguments.hpp>
#include <rtt/transports/corba/detail/later.hpp>
#include <rtt/transports/corba/detail/serving.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/Types.hpp>

#include <boost/shared_ptr.hpp>

#include <stdexcept>
#include <utility>

namespace RTT::corba::detail {

namespace {

typedef base::DataSourceBase::shared_ptr Source;
typedef OperationInterfacePart::Args Args;
typedef std::shared_ptr<const RemoteOperation> Operation;
using internal::CopyMap;

internal::OperationSignature::Value valueOf(const char* type, const std::string& name = "",
                                            const std::string& description = "") {
    auto value = internal::OperationSignature::Value::parsed(type);
    value.type = types::Types()->type(value.typeName);
    value.id = value.type ? value.type->getTypeId() : nullptr;
    value.name = name;
    value.description = description;
    return value;
}

/** What a caller gives to an operation. */
struct Use {
    Operation operation;
    Args arguments;

    CAnyArguments values() const {
        CAnyArguments all;
        setValues(all, arguments);
        return all;
    }
    void evaluate() const {
        for (std::size_t i = 0; i != arguments.size(); ++i)
            if (!arguments[i]->evaluate())
                throw std::runtime_error("argument " + std::to_string(i + 1) + " of operation '" + operation->name +
                                         "' cannot be evaluated");
    }
    Use copy(CopyMap& cloned) const {
        Use made{operation, {}};
        for (const Source& argument : arguments) made.arguments.push_back(argument->copy(cloned));
        return made;
    }
};

class CallAction final : public base::ActionInterface {
public:
    CallAction(Use use, Source result) : use_(std::move(use)), result_(std::move(result)) {}

    void readArguments() override { use_.evaluate(); }
    bool execute() override {
        const RemoteOperation& operation = *use_.operation;
        CAnyArguments values = use_.values();
        CORBA::Any_var result;
        try {
            const CService_var service = operation.reachable(RemoteOperation::Unlimited);
            result = whileServing([&] { return service->callOperation(operation.name.c_str(), values); });
        } catch (const CORBA::Exception& error) {
            operation.fail(error);
        }
        for (CORBA::ULong i = 0; i != values.length() && i != use_.arguments.size(); ++i)
            if (operation.signature.arguments[i].isOutput()) (void)assign(values[i], use_.arguments[i]);
        return !result_ || assign(result, result_);
    }
    CallAction* clone() const override { return new CallAction(use_, result_); }
    CallAction* copy(CopyMap& cloned) const override {
        return new CallAction(use_.copy(cloned), result_ ? result_->copy(cloned) : nullptr);
    }

private:
    const Use use_;
    const Source result_;
};

/** A call without result. */
template <class Void>
class VoidCall final : public internal::DataSource<Void> {
public:
    explicit VoidCall(base::ActionInterface* action) : action_(action) {}
    bool evaluate() const override {
        action_->readArguments();
        return action_->execute();
    }
    void get() const override { (void)evaluate(); }
    void value() const override {}
    typename internal::DataSource<Void>::const_reference_t rvalue() const override {}
    VoidCall* clone() const override { return new VoidCall(action_->clone()); }
    VoidCall* copy(CopyMap& cloned) const override { return new VoidCall(action_->copy(cloned)); }

private:
    const std::unique_ptr<base::ActionInterface> action_;
};

/** A call that was sent. Its last user disposes of it in the other process. */
class RemoteHandle {
public:
    typedef boost::shared_ptr<RemoteHandle> Pointer;
    RemoteHandle(Operation operation, CSendHandle_ptr handle)
        : operation_(std::move(operation)), handle_(handle), limited_(limited<CSendHandle>(handle)) {}
    ~RemoteHandle() {
        later([handle = limited_] { handle->dispose(); });
    }
    RemoteHandle(const RemoteHandle&) = delete;
    RemoteHandle& operator=(const RemoteHandle&) = delete;

    SendStatus collect(bool wait, const Args& into) const {
        try {
            CAnyArguments_var values;
            const CSendStatus status = wait ? whileServing([&] { return handle_->collect(values.out()); })
                                            : limited_->collectIfDone(values.out());
            if (status == CSendSuccess)
                for (CORBA::ULong i = 0; i != values->length() && i != into.size(); ++i)
                    if (into[i] && !assign(values[i], into[i])) return CollectFailure;
            return static_cast<SendStatus>(static_cast<int>(status) - 2);
        } catch (const CORBA::Exception& error) {
            operation_->fail(error);
        }
    }

private:
    const Operation operation_;
    const CSendHandle_var handle_, limited_;
};

class SendSource final : public internal::DataSource<RemoteHandle::Pointer> {
public:
    explicit SendSource(Use use) : use_(std::move(use)) {}
    RemoteHandle::Pointer get() const override {
        sent_.reset();
        use_.evaluate();
        const RemoteOperation& operation = *use_.operation;
        try {
            const CService_var service = operation.reachable(RemoteOperation::Limited);
            sent_.reset(new RemoteHandle(use_.operation, whileServing([&] {
                                             return service->sendOperation(operation.name.c_str(), use_.values());
                                         })));
        } catch (const CORBA::Exception& error) {
            operation.fail(error);
        }
        return sent_;
    }
    RemoteHandle::Pointer value() const override { return sent_; }
    const RemoteHandle::Pointer& rvalue() const override { return sent_; }
    SendSource* clone() const override { return new SendSource(use_); }
    SendSource* copy(CopyMap& cloned) const override { return new SendSource(use_.copy(cloned)); }

private:
    const Use use_;
    mutable RemoteHandle::Pointer sent_;
};

class CollectSource final : public internal::DataSource<SendStatus> {
public:
    typedef internal::DataSource<RemoteHandle::Pointer>::shared_ptr HandleSource;
    typedef internal::DataSource<bool>::shared_ptr Blocking;
    CollectSource(HandleSource handle, Args variables, Blocking blocking)
        : handle_(std::move(handle)), variables_(std::move(variables)), blocking_(std::move(blocking)) {}
    SendStatus get() const override {
        const RemoteHandle::Pointer sent = handle_->get();
        return status_ = sent ? sent->collect(!blocking_ || blocking_->get(), variables_) : SendFailure;
    }
    SendStatus value() const override { return status_; }
    const SendStatus& rvalue() const override { return status_; }
    CollectSource* clone() const override { return new CollectSource(handle_, variables_, blocking_); }
    CollectSource* copy(CopyMap& cloned) const override {
        Args variables;
        for (const Source& one : variables_) variables.push_back(one ? one->copy(cloned) : nullptr);
        return new CollectSource(handle_->copy(cloned), std::move(variables),
                                 blocking_ ? blocking_->copy(cloned) : nullptr);
    }

private:
    const HandleSource handle_;
    const Args variables_;
    const Blocking blocking_;
    mutable SendStatus status_ = SendNotReady;
};

}  // namespace

CService_var RemoteOperation::reachable(Patience patience) const {
    const CService_var found = peer->isLost()        ? CService_var()
                               : patience == Limited ? service->getLimited()
                                                     : service->get();
    if (CORBA::is_nil(found))
        throw std::runtime_error("operation '" + name + "' of component '" + peer->name() +
                                 "': its process does not answer");
    return found;
}

void RemoteOperation::fail(const CORBA::Exception& error) const {
    const std::string call = "operation '" + name + "' of component '" + peer->name() + "': ";
    if (const auto* const thrown = CCallError::_downcast(&error)) throw std::runtime_error(thrown->what.in());
    if (CNoSuchNameException::_downcast(&error)) throw std::runtime_error(call + "it has no such operation any more");
    if (const auto* const wrong = CWrongTypeArgException::_downcast(&error))
        throw std::runtime_error(call + "argument " + std::to_string(wrong->whicharg) + " has type " +
                                 wrong->received.in() + ", expected " + wrong->expected.in());
    if (const auto* const wrong = CWrongNumbArgException::_downcast(&error))
        throw std::runtime_error(call + "found " + std::to_string(wrong->received) + " arguments, expected " +
                                 std::to_string(wrong->wanted));
    peer->failed(error);
    throw std::runtime_error(call + describe(error));
}

namespace {

std::string formOf(const COperation& described) {
    std::string form = described.result_type.in();
    for (CORBA::ULong i = 0; i != described.arguments.length(); ++i)
        form += std::string(",") + described.arguments[i].type.in();
    return form;
}

}  // namespace

bool RemotePart::is(const COperation& described) const { return form_ == formOf(described); }

RemotePart::RemotePart(std::shared_ptr<RemotePeer> peer, std::shared_ptr<const RemoteReference> service,
                       const COperation& described)
    : form_(formOf(described)) {
    auto operation = std::make_shared<RemoteOperation>();
    operation->peer = std::move(peer);
    operation->service = std::move(service);
    operation->name = described.name.in();
    operation->description = described.description.in();
    operation->signature.result = valueOf(described.result_type);
    for (CORBA::ULong i = 0; i != described.arguments.length(); ++i) {
        const CArgumentDescription& one = described.arguments[i];
        operation->signature.arguments.push_back(valueOf(one.type, one.name.in(), one.description.in()));
    }
    operation_ = std::move(operation);
}

Source RemotePart::produce(const Args& args, ExecutionEngine*) const {
    Use use{operation_, checkedArguments(args)};
    const types::TypeInfo* const type = operation_->signature.result.type;
    if (operation_->signature.result.isVoid() || !type)
        return new VoidCall<void>(new CallAction(std::move(use), nullptr));
    // A variable as in programs, so that copies of the expression have their own results.
    const std::unique_ptr<base::AttributeBase> holder(type->buildVariable("result"));
    const Source result = holder->getDataSource();
    auto action = std::make_unique<CallAction>(std::move(use), result);
    const Source made = type->buildActionAlias(action.get(), result);
    if (!made) throw std::runtime_error("a result of type " + type->getTypeName() + " cannot be given to others");
    (void)action.release();
    return made;
}

Source RemotePart::produceSend(const Args& args, ExecutionEngine*) const {
    return new SendSource({operation_, checkedArguments(args)});
}

Source RemotePart::produceHandle() const { return new internal::ValueDataSource<RemoteHandle::Pointer>(); }

Source RemotePart::produceCollect(const Args& args, internal::DataSource<bool>::shared_ptr blocking) const {
    auto* const handle = internal::DataSource<RemoteHandle::Pointer>::narrow(args.empty() ? nullptr : args[0].get());
    checkCollected(args, handle != nullptr);
    return new CollectSource(handle, Args(args.begin() + 1, args.end()), std::move(blocking));
}

}  // namespace RTT::corba::detail
