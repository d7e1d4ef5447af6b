// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_OPERATION_SERVANT_HPP
#define ORO_CORBA_DETAIL_OPERATION_SERVANT_HPP

#include <rtt/OperationInterfacePart.hpp>
#include <rtt/transports/corba/detail/service_part.hpp>

#include <string>

namespace RTT {
namespace corba {
namespace detail {

/** The operations of a service, except for those that can only be called in their own process. */
class OperationServant : public virtual POA_RTT::corba::COperationInterface, protected virtual ServicePart {
public:
    /** ServiceServant makes the ServicePart. */
    OperationServant() : ServicePart(nullptr, nullptr) {}

    corba::COperationInterface::COperationDescriptions* getOperations() override;
    CArgumentDescriptions* getArguments(const char* operation) override;
    CORBA::UShort getArity(const char* operation) override;
    CORBA::UShort getCollectArity(const char* operation) override;
    char* getResultType(const char* operation) override;
    char* getArgumentType(const char* operation, CORBA::UShort nbr) override;
    char* getCollectType(const char* operation, CORBA::UShort nbr) override;
    char* getDescription(const char* operation) override;
    void checkOperation(const char* operation, const CAnyArguments& args) override;
    CORBA::Any* callOperation(const char* operation, CAnyArguments& args) override;
    CSendHandle_ptr sendOperation(const char* operation, const CAnyArguments& args) override;
    void sendOperationOneway(const char* operation, const CAnyArguments& args) override;

private:
    typedef OperationInterfacePart::shared_constptr Part;
    /** Throws CNoSuchNameException. */
    Part find(const char* operation) const;
};

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
