// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_DETAIL_PART_SEND_HPP
#define ORO_INTERNAL_DETAIL_PART_SEND_HPP

#include <rtt/internal/SendHandleC.hpp>
#include <rtt/internal/calls/detail/remote_values.hpp>

namespace RTT {
namespace internal {
namespace detail {

/** A call that was sent through the data sources of an operation. */
class PartSend final : public RemoteCollect {
public:
    /** Null if the operation was refused; throws if it cannot be sent. */
    static std::unique_ptr<PartSend> make(const OperationInterfacePart& part, const CallerSignature& signature,
                                          ExecutionEngine* caller, void* const* arguments, void* result);
    SendStatus collect(bool wait) override;

private:
    PartSend(const CallerSignature& signature, void* const* arguments, void* result);
    void collectFrom(const Source& handle, const OperationInterfacePart& part);

    CallerSources values_;
    const std::vector<void*> arguments_;
    void* const result_;
    SendHandleC handle_;
    std::vector<Assignment> conversions_;  // of values collected as another type
};

}  // namespace detail
}  // namespace internal
}  // namespace RTT

#endif
