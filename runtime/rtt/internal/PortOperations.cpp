// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/internal/PortOperations.hpp>

#include <rtt/Service.hpp>
#include <rtt/base/InputPortInterface.hpp>
#include <rtt/base/OutputPortInterface.hpp>
#include <rtt/internal/Reclaimer.hpp>

namespace RTT {
namespace internal {

PortLink::PortLink(const base::PortInterface& port)
    : endpoint_(port.getEndpoint()), input_(dynamic_cast<const base::InputPortInterface*>(&port) != nullptr) {}
PortLink::PortLink(const PortLink&) = default;
PortLink::~PortLink() = default;

// Within the Guard the port's destructor waits for us.
FlowStatus PortLink::read(void* sample) const {
    const Reclaimer::Guard guard;
    auto* const port = static_cast<base::InputPortInterface*>(endpoint_->getPort());
    return port ? port->readSample(sample, true) : NoData;
}

WriteStatus PortLink::write(const void* sample) const {
    const Reclaimer::Guard guard;
    auto* const port = static_cast<base::OutputPortInterface*>(endpoint_->getPort());
    return port ? port->writeSample(sample) : NotConnected;
}

bool PortLink::last(void* sample) const {
    const Reclaimer::Guard guard;
    auto* const port = static_cast<base::OutputPortInterface*>(endpoint_->getPort());
    return port && port->copyLastWritten(sample);
}

bool PortLink::fetch(void* sample) const { return input_ ? read(sample) != NoData : last(sample); }

PortCallee::~PortCallee() = default;

namespace {

/** Serves all signatures; the caller and the table know which it is. */
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

}  // namespace internal
}  // namespace RTT
