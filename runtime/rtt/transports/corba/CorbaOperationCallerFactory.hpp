// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_OPERATION_CALLER_FACTORY_HPP
#define ORO_CORBA_OPERATION_CALLER_FACTORY_HPP

#include <rtt/OperationInterfacePart.hpp>
#include <rtt/transports/corba/ServiceC.h>
#include <rtt/transports/corba/corba.h>

#include <memory>
#include <string>
#include <vector>

namespace RTT {
namespace corba {

/**
 * An operation of a service of another process: add it to a Service, or give it to an OperationCaller. Its functions do
 * not block, but the sources that it produces call the other process and do. They throw std::runtime_error if that does
 * not answer.
 */
class RTT_API CorbaOperationCallerFactory : public OperationInterfacePart {
public:
    /** Asks the other process for the operation. Throws name_not_found_exception if there is none, and
        CORBA::SystemException. `poa` is not used. */
    CorbaOperationCallerFactory(const std::string& operation, CService_ptr service, PortableServer::POA_ptr poa);
    ~CorbaOperationCallerFactory() override;

    std::string getName() const override;
    std::string description() const override;
    std::vector<ArgumentDescription> getArgumentList() const override;
    std::string resultType() const override;
    unsigned arity() const override;
    const types::TypeInfo* getArgumentType(unsigned index) const override;
    unsigned collectArity() const override;
    const types::TypeInfo* getCollectType(unsigned index) const override;
    internal::OperationSignature signature() const override;

    base::DataSourceBase::shared_ptr produce(const Args& args, ExecutionEngine* caller) const override;
    base::DataSourceBase::shared_ptr produceSend(const Args& args, ExecutionEngine* caller) const override;
    base::DataSourceBase::shared_ptr produceHandle() const override;
    base::DataSourceBase::shared_ptr produceCollect(
        const Args& args, boost::intrusive_ptr<internal::DataSource<bool>> blocking) const override;

private:
    const std::unique_ptr<const OperationInterfacePart> part_;
};

}  // namespace corba
}  // namespace RTT

#endif
