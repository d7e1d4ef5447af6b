// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A service as an operation that callers can be bound to.
#include <rtt/Logger.hpp>
#include <rtt/OperationCaller.hpp>
#include <rtt/SendStatus.hpp>
#include <rtt/base/ActionInterface.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/types/Types.hpp>
#include <rtt_roscomm/service_client.hpp>

#include <stdexcept>
#include <utility>

namespace rtt_roscomm {

namespace {

using RTT::SendStatus;
using RTT::internal::DataSource;
using RTT::internal::OperationSignature;
using RTT::internal::ValueDataSource;
typedef RTT::base::DataSourceBase::shared_ptr Source;
typedef RTT::OperationInterfacePart::Args Args;
typedef std::shared_ptr<ServiceConnection> Connection;
typedef std::map<const RTT::base::DataSourceBase*, RTT::base::DataSourceBase*> CopyMap;

/** What all uses of the operation share. */
struct Service {
    Connection connection;
    Form form;

    /** False, with an error logged, if the values cannot be sent. */
    bool make(ros::SerializedMessage& request, const CallValues& values) const {
        try {
            request = requestOf(values);
            return true;
        } catch (const std::exception& error) {
            connection->failed(error.what());
            return false;
        }
    }
    ros::SerializedMessage requestOf(const CallValues& values) const {
        const std::size_t size = form->requestSize(values);
        if (size > UINT32_MAX - 4) throw std::runtime_error("the request has more than 4 GB");
        ros::SerializedMessage message(boost::shared_array<std::uint8_t>(new std::uint8_t[size + 4]), size + 4);
        for (unsigned i = 0; i != 4; ++i) message.buf[i] = static_cast<std::uint8_t>(size >> (8 * i));
        message.message_start = message.buf.get() + 4;
        form->encodeRequest(values, message.message_start, size);
        return message;
    }
    /** False, with an error logged, if it is malformed. */
    bool take(const ros::SerializedMessage& response, const CallValues& values) const {
        try {
            const std::uint8_t* const first = response.message_start ? response.message_start : response.buf.get();
            const auto head = static_cast<std::size_t>(first - response.buf.get());
            form->decodeResponse(first, response.num_bytes - head, values);
            return true;
        } catch (const std::exception& error) {
            connection->failed(error.what());
            return false;
        }
    }
};

void evaluateAll(const Service& service, const Args& arguments) {
    for (std::size_t i = 0; i != arguments.size(); ++i)
        if (!arguments[i]->evaluate())
            throw std::runtime_error(service.connection->who() + ": argument " + std::to_string(i + 1) +
                                     " cannot be evaluated");
}

Args copied(const Args& arguments, CopyMap& cloned) {
    Args made;
    for (const Source& one : arguments) made.push_back(one ? one->copy(cloned) : nullptr);
    return made;
}

class CallAction final : public RTT::base::ActionInterface {
public:
    CallAction(Service service, CallValues values) : service_(std::move(service)), values_(std::move(values)) {}

    void readArguments() override { evaluateAll(service_, values_.arguments); }
    bool execute() override {
        ros::SerializedMessage request, response;
        if (!service_.make(request, values_) || !service_.connection->call(request, response) ||
            !service_.take(response, values_))
            service_.form->fail(values_);
        return true;
    }
    CallAction* clone() const override { return new CallAction(service_, values_); }
    CallAction* copy(CopyMap& cloned) const override {
        return new CallAction(service_, {copied(values_.arguments, cloned),
                                         values_.result ? values_.result->copy(cloned) : nullptr});
    }

private:
    const Service service_;
    const CallValues values_;
};

/** A call without result. */
template <class Void>
class VoidCall final : public DataSource<Void> {
public:
    explicit VoidCall(RTT::base::ActionInterface* action) : action_(action) {}
    bool evaluate() const override {
        action_->readArguments();
        return action_->execute();
    }
    void get() const override { (void)evaluate(); }
    void value() const override {}
    typename DataSource<Void>::const_reference_t rvalue() const override {}
    VoidCall* clone() const override { return new VoidCall(action_->clone()); }
    VoidCall* copy(CopyMap& cloned) const override { return new VoidCall(action_->copy(cloned)); }

private:
    const std::unique_ptr<RTT::base::ActionInterface> action_;
};

typedef std::shared_ptr<SentRequest> Handle;

class SendSource final : public DataSource<Handle> {
public:
    SendSource(Service service, Args arguments) : service_(std::move(service)), arguments_(std::move(arguments)) {}
    Handle get() const override {
        evaluateAll(service_, arguments_);
        ros::SerializedMessage request;
        sent_ = service_.make(request, {arguments_, nullptr}) ? service_.connection->send(request) : nullptr;
        return sent_;
    }
    Handle value() const override { return sent_; }
    const Handle& rvalue() const override { return sent_; }
    SendSource* clone() const override { return new SendSource(service_, arguments_); }
    SendSource* copy(CopyMap& cloned) const override { return new SendSource(service_, copied(arguments_, cloned)); }

private:
    const Service service_;
    const Args arguments_;
    mutable Handle sent_;
};

class CollectSource final : public DataSource<SendStatus> {
public:
    typedef DataSource<Handle>::shared_ptr HandleSource;
    typedef DataSource<bool>::shared_ptr Blocking;
    /** The values are those of a call; of its arguments only those exist that it gives. */
    CollectSource(Service service, HandleSource handle, CallValues values, Blocking blocking)
        : service_(std::move(service)),
          handle_(std::move(handle)),
          values_(std::move(values)),
          blocking_(std::move(blocking)) {}
    SendStatus get() const override {
        const Handle sent = handle_->get();
        if (!sent) return status_ = RTT::SendFailure;
        SentRequest& request = *sent;
        if (!service_.connection->finish(request, !blocking_ || blocking_->get())) return status_ = RTT::SendNotReady;
        const bool isGiven = request.isAnswered && service_.take(request.response, values_);
        if (!isGiven) service_.form->fail(values_);
        return status_ = isGiven ? RTT::SendSuccess : RTT::CollectFailure;
    }
    SendStatus value() const override { return status_; }
    const SendStatus& rvalue() const override { return status_; }
    CollectSource* clone() const override { return new CollectSource(service_, handle_, values_, blocking_); }
    CollectSource* copy(CopyMap& cloned) const override {
        return new CollectSource(
            service_, handle_->copy(cloned),
            {copied(values_.arguments, cloned), values_.result ? values_.result->copy(cloned) : nullptr},
            blocking_ ? blocking_->copy(cloned) : nullptr);
    }

private:
    const Service service_;
    const HandleSource handle_;
    const CallValues values_;
    const Blocking blocking_;
    mutable SendStatus status_ = RTT::SendNotReady;
};

/** Tells callers that are bound to the service whether it is connected. */
class Readiness final : public RTT::base::OperationCallerInterface {
public:
    explicit Readiness(Connection connection) : connection_(std::move(connection)) {}
    bool ready() const override { return connection_->isOpen(); }
    Readiness* cloneI(RTT::ExecutionEngine*) const override { return new Readiness(connection_); }

private:
    const Connection connection_;
};

class ServicePart final : public RTT::internal::SignedPart {
public:
    explicit ServicePart(Service service) : service_(std::move(service)) {}

    std::string getName() const override { return service_.connection->name(); }
    std::string description() const override { return "A service of ROS."; }
    std::string signatureText() const { return service_.form->text(); }
    OperationSignature signature() const override { return service_.form->signature(); }
    RTT::base::DisposableInterface::shared_ptr getLocalOperation() const override {
        return boost::make_shared<Readiness>(service_.connection);
    }

    Source produce(const Args& args, RTT::ExecutionEngine*) const override {
        CallValues values{checkedArguments(args), nullptr};
        const RTT::types::TypeInfo* const type = signature().result.type;
        if (!type) return new VoidCall<void>(new CallAction(service_, std::move(values)));
        values.result = type->buildValue();
        const Source result = values.result;
        auto action = std::make_unique<CallAction>(service_, std::move(values));
        const Source made = type->buildActionAlias(action.get(), result);
        if (!made) throw std::runtime_error("a result of type " + type->getTypeName() + " cannot be given to others");
        (void)action.release();
        return made;
    }
    Source produceSend(const Args& args, RTT::ExecutionEngine*) const override {
        return new SendSource(service_, checkedArguments(args));
    }
    Source produceHandle() const override { return new ValueDataSource<Handle>(); }
    Source produceCollect(const Args& args, DataSource<bool>::shared_ptr blocking) const override {
        auto* const handle = DataSource<Handle>::narrow(args.empty() ? nullptr : args[0].get());
        checkCollected(args, handle != nullptr);
        const OperationSignature own = signature();
        // Without variables, the values go nowhere.
        CallValues values{service_.form->variables(), nullptr};
        std::size_t next = 1;
        if (!own.result.isVoid() && next < args.size()) values.result = args[next++];
        for (std::size_t i = 0; i != own.arguments.size(); ++i)
            if (own.arguments[i].isOutput() && next < args.size()) values.arguments[i] = args[next++];
        return new CollectSource(service_, handle, std::move(values), std::move(blocking));
    }

private:
    const Service service_;
};

}  // namespace

bool bindCaller(RTT::base::OperationCallerBaseInvoker& caller, const Connection& connection, Form form,
                RTT::ExecutionEngine* engine) {
    const boost::shared_ptr<ServicePart> part(new ServicePart({connection, std::move(form)}));
    if (caller.setImplementationPart(part.get(), engine)) return true;
    RTT::log(RTT::Error) << connection->who() << " cannot use service '" << connection->name()
                         << "': give it the signature " << part->signatureText() << RTT::endlog();
    return false;
}

}  // namespace rtt_roscomm
