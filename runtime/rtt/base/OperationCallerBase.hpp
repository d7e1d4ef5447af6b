// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OPERATION_CALLER_BASE_HPP
#define ORO_OPERATION_CALLER_BASE_HPP

#include <rtt/SendHandle.hpp>
#include <rtt/base/OperationCallerInterface.hpp>

namespace RTT {
namespace base {

template <class Signature>
class OperationCallerBase;

/** An operation of a known signature: local, or remote in a transport. */
template <class R, class... Args>
class OperationCallerBase<R(Args...)> : public OperationCallerInterface {
public:
    typedef boost::shared_ptr<OperationCallerBase> shared_ptr;

    virtual R call(Args... args) = 0;
    virtual SendHandle<R(Args...)> send(Args... args) = 0;
    /** The same operation for another caller. The caller of this function owns it. */
    OperationCallerBase* cloneI(ExecutionEngine* caller) const override = 0;

protected:
    OperationCallerBase() = default;
    OperationCallerBase(const OperationCallerBase& other, ExecutionEngine* caller)
        : OperationCallerInterface(other, caller) {}
};

}  // namespace base
}  // namespace RTT

#endif
