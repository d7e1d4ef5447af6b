// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_OPERATION_PART_HPP
#define ORO_INTERNAL_OPERATION_PART_HPP

#include <rtt/base/OperationBase.hpp>
#include <rtt/internal/calls/operation_signature.hpp>

#include <typeinfo>

namespace RTT {
namespace internal {

/** An operation of this process, for callers that learn its signature at run time. */
class RTT_API OperationPart final : public SignedPart {
public:
    typedef base::DataSourceBase::shared_ptr Source;
    typedef base::OperationCallerInterface::shared_ptr Caller;

    OperationPart(std::shared_ptr<const base::OperationDescription> description, Caller caller,
                  const OperationTable& table, bool callOnly);

    std::string getName() const override;
    std::string description() const override;
    OperationSignature signature() const override;
    bool isSynchronous() const override { return call_only_; }
    base::DisposableInterface::shared_ptr getLocalOperation() const override { return caller_; }

    const Caller& caller() const { return caller_; }
    /** C++ callers with this signature call `other`, in the thread of the operation. Other callers do not see it. */
    void overload(const std::type_info& signature, Caller other);
    /** The overload for a signature, or the operation itself. */
    const Caller& callerOf(const std::type_info& signature) const;
    /** The first overload, or the operation itself. */
    const Caller& firstCaller() const { return overloads_.empty() ? caller_ : overloads_.front().caller; }
    void setThread(ExecutionThread et, ExecutionEngine* owner) const;

    Source produce(const Args& args, ExecutionEngine* caller) const override;
    Source produceSend(const Args& args, ExecutionEngine* caller) const override;
    Source produceHandle() const override;
    Source produceCollect(const Args& args, boost::intrusive_ptr<DataSource<bool>> blocking) const override;
    Handle produceSignal(base::ActionInterface* action, const Args& args, ExecutionEngine* subscriber) const override;

    /** The same operation with another function; null if the function has another signature. Subscribers to this
        operation are subscribed to the new one. The caller owns it. */
    OperationPart* reimplemented(const base::OperationBase& by) const;

private:
    OperationSignature types() const override;
    /** checkedArguments() that are fast if there is nothing to convert. */
    Args accepted(const Args& args) const;
    void checkSendable() const;

    struct Overload {
        const std::type_info* signature;
        Caller caller;
    };
    std::shared_ptr<const base::OperationDescription> description_;
    Caller caller_;
    const OperationTable* table_;
    bool call_only_;
    std::vector<Overload> overloads_;
};

}  // namespace internal
}  // namespace RTT

#endif
