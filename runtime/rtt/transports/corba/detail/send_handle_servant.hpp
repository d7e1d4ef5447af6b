// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_CORBA_DETAIL_SEND_HANDLE_SERVANT_HPP
#define ORO_CORBA_DETAIL_SEND_HANDLE_SERVANT_HPP

#include <rtt/internal/SendHandleC.hpp>
#include <rtt/transports/corba/detail/served_component.hpp>

#include <mutex>

namespace RTT {
namespace corba {
namespace detail {

/** A call that another process has sent, until that process disposes of it. */
class SendHandleServant final : public POA_RTT::corba::CSendHandle {
public:
    SendHandleServant(Served served, OperationInterfacePart::shared_constptr part, internal::SendHandleC handle);

    CSendStatus collect(CAnyArguments_out args) override;
    CSendStatus collectIfDone(CAnyArguments_out args) override;
    CSendStatus checkStatus() override;
    CORBA::Any* ret() override;
    void checkArguments(const CAnyArguments& args) override;
    void dispose() override;

private:
    CSendStatus fetch(CAnyArguments_out args, bool wait);
    SendStatus fetch(bool wait);

    const Served served_;
    const OperationInterfacePart::shared_constptr part_;
    const OperationInterfacePart::Args collected_;
    std::mutex mutex_;  // guards the handle
    internal::SendHandleC handle_;
};

}  // namespace detail
}  // namespace corba
}  // namespace RTT

#endif
