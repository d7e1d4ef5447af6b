// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/CorbaOperationCallerFactory.hpp>

#include <rtt/internal/DataSource.hpp>
#include <rtt/transports/corba/detail/lone_service.hpp>
#include <rtt/transports/corba/detail/remote_part.hpp>

#include <memory>
#include <utility>

namespace RTT::corba {

namespace {

std::unique_ptr<const OperationInterfacePart> find(const std::string& name, CService_ptr service) {
    COperationInterface::COperationDescriptions_var all = service->getOperations();
    for (CORBA::ULong i = 0; i != all->length(); ++i) {
        if (name != all[i].name.in()) continue;
        const CORBA::String_var owner = service->getName();
        const std::shared_ptr<detail::LoneService> peer = detail::LoneService::of(service, owner.in());
        return std::make_unique<detail::RemotePart>(peer, peer->reference(), all[i]);
    }
    throw name_not_found_exception(name);
}

}  // namespace

CorbaOperationCallerFactory::CorbaOperationCallerFactory(const std::string& operation, CService_ptr service,
                                                         PortableServer::POA_ptr)
    : part_(find(operation, service)) {}

CorbaOperationCallerFactory::~CorbaOperationCallerFactory() = default;

std::string CorbaOperationCallerFactory::getName() const { return part_->getName(); }
std::string CorbaOperationCallerFactory::description() const { return part_->description(); }
std::vector<ArgumentDescription> CorbaOperationCallerFactory::getArgumentList() const {
    return part_->getArgumentList();
}
std::string CorbaOperationCallerFactory::resultType() const { return part_->resultType(); }
unsigned CorbaOperationCallerFactory::arity() const { return part_->arity(); }
const types::TypeInfo* CorbaOperationCallerFactory::getArgumentType(unsigned index) const {
    return part_->getArgumentType(index);
}
unsigned CorbaOperationCallerFactory::collectArity() const { return part_->collectArity(); }
const types::TypeInfo* CorbaOperationCallerFactory::getCollectType(unsigned index) const {
    return part_->getCollectType(index);
}
internal::OperationSignature CorbaOperationCallerFactory::signature() const { return part_->signature(); }

base::DataSourceBase::shared_ptr CorbaOperationCallerFactory::produce(const Args& args, ExecutionEngine* caller) const {
    return part_->produce(args, caller);
}
base::DataSourceBase::shared_ptr CorbaOperationCallerFactory::produceSend(const Args& args,
                                                                          ExecutionEngine* caller) const {
    return part_->produceSend(args, caller);
}
base::DataSourceBase::shared_ptr CorbaOperationCallerFactory::produceHandle() const { return part_->produceHandle(); }
base::DataSourceBase::shared_ptr CorbaOperationCallerFactory::produceCollect(
    const Args& args, boost::intrusive_ptr<internal::DataSource<bool>> blocking) const {
    return part_->produceCollect(args, std::move(blocking));
}

}  // namespace RTT::corba
