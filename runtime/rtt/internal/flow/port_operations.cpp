// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/flow/port_operations.hpp>

#include <rtt/Service.hpp>
#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>

namespace RTT::internal {

PortCallee::~PortCallee() = default;

namespace {

/** Serves all signatures: the caller and the table know the signature. */
class SampleOperation final : public base::OperationBase {
public:
    SampleOperation(const std::string& name, base::OperationCallerInterface* caller, const OperationTable& table,
                    const std::string& text)
        : OperationBase(name, caller, table) {
        setDoc(text);
    }
    SampleOperation* arg(const std::string& name, const std::string& text) {
        addArgument(name, text);
        return this;
    }
};

}  // namespace

void PortOperation::add(Service& object, base::PortInterface& port, base::OperationBase* operation) {
    object.adopt(operation, new PortCallee(port), ClientThread, true);
}

void PortOperation::addRead(Service& object, base::PortInterface& port, base::OperationCallerInterface* caller,
                            const OperationTable& table) {
    add(object, port,
        (new SampleOperation("read", caller, table, "Reads a sample from the port."))
            ->arg("sample", "Where the sample goes."));
}

void PortOperation::addWrite(Service& object, base::PortInterface& port, base::OperationCallerInterface* caller,
                             const OperationTable& table) {
    add(object, port,
        (new SampleOperation("write", caller, table, "Writes a sample to the port."))->arg("sample", "The sample."));
}

void PortOperation::addLast(Service& object, base::PortInterface& port, base::OperationCallerInterface* caller,
                            const OperationTable& table) {
    add(object, port,
        new SampleOperation("last", caller, table, "Gives the last written value, a default one if there is none."));
}

void PortOperation::invokeRead(base::OperationCallerInterface& caller, void* const* arguments, void* result) {
    static_cast<ResultStore<FlowStatus>*>(result)->take([&] { return PortCallee::linkOf(caller).read(arguments[0]); });
}

void PortOperation::invokeWrite(base::OperationCallerInterface& caller, void* const* arguments, void* result) {
    static_cast<ResultStore<WriteStatus>*>(result)->take(
        [&] { return PortCallee::linkOf(caller).write(arguments[0]); });
}

SentCall::shared_ptr PortOperation::refuse(base::OperationCallerInterface&, void* const*) { return nullptr; }

base::DataSourceBase* PortOperation::makeRead(GenericCall&& call) {
    return new CallSource<FlowStatus>(std::move(call));
}

base::DataSourceBase* PortOperation::makeWrite(GenericCall&& call) {
    return new CallSource<WriteStatus>(std::move(call));
}

}  // namespace RTT::internal
