// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/operation_servant.hpp>

#include <rtt/Logger.hpp>
#include <rtt/internal/GlobalEngine.hpp>
#include <rtt/internal/OperationCallerC.hpp>
#include <rtt/internal/calls/operation_signature.hpp>
#include <rtt/transports/corba/detail/any_values.hpp>
#include <rtt/transports/corba/detail/call_arguments.hpp>
#include <rtt/transports/corba/detail/load_plugin.hpp>
#include <rtt/transports/corba/detail/send_handle_servant.hpp>
#include <rtt/types/TypeInfo.hpp>

#include <algorithm>
#include <exception>
#include <utility>

namespace RTT::corba::detail {

namespace {

CORBA::UShort count(unsigned number) { return static_cast<CORBA::UShort>(number); }

void describe(CArgumentDescriptions& list, const OperationInterfacePart& part) {
    const std::vector<ArgumentDescription> arguments = part.getArgumentList();
    list.length(static_cast<CORBA::ULong>(arguments.size()));
    for (CORBA::ULong i = 0; i != list.length(); ++i) {
        list[i].name = arguments[i].name.c_str();
        list[i].description = arguments[i].description.c_str();
        list[i].type = arguments[i].type.c_str();
    }
}

void describe(COperation& described, const OperationInterfacePart& part) {
    described.name = part.getName().c_str();
    described.description = part.description().c_str();
    describe(described.arguments, part);
    described.collect_types.length(part.collectArity());
    for (unsigned i = 0; i != part.collectArity(); ++i) {
        const types::TypeInfo* const type = part.getCollectType(i + 1);
        described.collect_types[i] = type ? type->getTypeName().c_str() : "unknown_t";
    }
    described.result_type = part.resultType().c_str();
    described.send_oneway = part.collectArity() == 0;
}

/** Otherwise the caller gets back what it gave. */
bool hasOutputs(const internal::OperationSignature& signature) {
    return std::any_of(signature.arguments.begin(), signature.arguments.end(),
                       [](const auto& argument) { return argument.isOutput(); });
}

ExecutionEngine* caller() { return internal::GlobalEngine::Instance(); }

}  // namespace

OperationServant::Part OperationServant::find(const char* operation) const {
    const OperationInterfacePart* found = service_->getPart(operation);
    if (!found) found = operationsOfEveryService().getPart(operation);
    if (!found || found->isSynchronous()) throw CNoSuchNameException(operation);
    return OperationInterfacePart::hold(found);
}

corba::COperationInterface::COperationDescriptions* OperationServant::getOperations() {
    const ServedComponent::Use use(*served_);
    corba::COperationInterface::COperationDescriptions_var list =
        new corba::COperationInterface::COperationDescriptions();
    const auto add = [&](const OperationInterfacePart* part) {
        if (!part || part->isSynchronous()) return;
        const CORBA::ULong index = list->length();
        list->length(index + 1);
        describe(list[index], *part);
    };
    for (const std::string& name : service_->getNames()) add(service_->getPart(name));
    const OperationInterface& ofAll = operationsOfEveryService();
    for (const std::string& name : ofAll.getNames())
        if (!service_->getPart(name)) add(ofAll.getPart(name));
    return list._retn();
}

CArgumentDescriptions* OperationServant::getArguments(const char* operation) {
    const ServedComponent::Use use(*served_);
    CArgumentDescriptions_var list = new CArgumentDescriptions();
    describe(list.inout(), *find(operation));
    return list._retn();
}

CORBA::UShort OperationServant::getArity(const char* operation) {
    const ServedComponent::Use use(*served_);
    return count(find(operation)->arity());
}

CORBA::UShort OperationServant::getCollectArity(const char* operation) {
    const ServedComponent::Use use(*served_);
    return count(find(operation)->collectArity());
}

char* OperationServant::getResultType(const char* operation) {
    const ServedComponent::Use use(*served_);
    return CORBA::string_dup(find(operation)->resultType().c_str());
}

char* OperationServant::getArgumentType(const char* operation, CORBA::UShort nbr) {
    const ServedComponent::Use use(*served_);
    const Part part = find(operation);
    if (nbr == 0) return CORBA::string_dup(part->resultType().c_str());
    if (nbr > part->arity()) throw CWrongArgumentException(nbr, static_cast<CORBA::Long>(part->arity()));
    return CORBA::string_dup(part->getArgumentList()[nbr - 1u].type.c_str());
}

char* OperationServant::getCollectType(const char* operation, CORBA::UShort nbr) {
    const ServedComponent::Use use(*served_);
    const Part part = find(operation);
    if (nbr == 0 || nbr > part->collectArity())
        throw CWrongArgumentException(nbr, static_cast<CORBA::Long>(part->collectArity()));
    const types::TypeInfo* const type = part->getCollectType(nbr);
    return CORBA::string_dup(type ? type->getTypeName().c_str() : "unknown_t");
}

char* OperationServant::getDescription(const char* operation) {
    const ServedComponent::Use use(*served_);
    return CORBA::string_dup(find(operation)->description().c_str());
}

void OperationServant::checkOperation(const char* operation, const CAnyArguments& args) {
    const ServedComponent::Use use(*served_);
    (void)argumentsOf(find(operation)->signature(), args);
}

// The call waits in this thread of the ORB if the component executes it in its own.
CORBA::Any* OperationServant::callOperation(const char* operation, CAnyArguments& args) {
    const ServedComponent::Use use(*served_);
    const Part part = find(operation);
    try {
        const internal::OperationSignature signature = part->signature();
        const OperationInterfacePart::Args arguments = argumentsOf(signature, args);
        const base::DataSourceBase::shared_ptr call = part->produce(arguments, caller());
        if (!call || !call->evaluate()) throw CCallError("the operation was not executed");
        if (hasOutputs(signature)) setValues(args, arguments);
        return newAny(call);
    } catch (const std::exception& error) {
        throw CCallError(error.what());
    }
}

CSendHandle_ptr OperationServant::sendOperation(const char* operation, const CAnyArguments& args) {
    const ServedComponent::Use use(*served_);
    const Part part = find(operation);
    internal::OperationCallerC call(part.get(), operation, caller());
    for (const base::DataSourceBase::shared_ptr& argument : argumentsOf(part->signature(), args)) call.arg(argument);
    auto* const handle = new SendHandleServant(served_, part, call.send());
    const CSendHandle_var reference = served_->activate<CSendHandle>(handle);
    served_->keep(handle);
    return CSendHandle::_duplicate(reference);
}

void OperationServant::sendOperationOneway(const char* operation, const CAnyArguments& args) {
    try {
        const ServedComponent::Use use(*served_);
        const Part part = find(operation);
        internal::OperationCallerC call(part.get(), operation, caller());
        for (const base::DataSourceBase::shared_ptr& argument : argumentsOf(part->signature(), args))
            call.arg(argument);
        (void)call.send();
    } catch (const CORBA::Exception& error) {
        log(Error) << "another process sends operation '" << operation << "' of service '" << service_->getName()
                   << "' without success: " << error._name() << endlog();
    } catch (const std::exception& thrown) {
        log(Error) << "another process sends operation '" << operation << "' of service '" << service_->getName()
                   << "' without success: " << thrown.what() << endlog();
    }
}

}  // namespace RTT::corba::detail
