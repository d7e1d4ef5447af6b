// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SEND_HANDLE_C_HPP
#define ORO_SEND_HANDLE_C_HPP

#include <rtt/OperationInterfacePart.hpp>
#include <rtt/SendStatus.hpp>
#include <rtt/base/AttributeBase.hpp>
#include <rtt/internal/DataSources.hpp>

#include <string>

namespace RTT {
namespace internal {

/** The handle of an operation that OperationCallerC sent. Copies refer to the same call. Not real-time safe. */
class RTT_API SendHandleC {
public:
    typedef base::DataSourceBase::shared_ptr Source;

    SendHandleC() = default;
    /** `part->produceHandle()` makes the handle. */
    SendHandleC(Source handle, const OperationInterfacePart* part, const std::string& name);
    ~SendHandleC();
    SendHandleC(const SendHandleC&) = default;
    SendHandleC& operator=(const SendHandleC&) = default;

    /** Where collecting puts the next value: the result, then each argument by reference. */
    SendHandleC& arg(Source variable);
    SendHandleC& arg(base::AttributeBase* attribute);
    template <class T>
    SendHandleC& arg(T& variable) {
        return arg(Source(new ReferenceDataSource<T>(variable)));
    }

    /** Waits for the end. SendFailure, with an error logged, if the operation was not sent or the number of `arg()`
        calls is wrong. Throws std::runtime_error if the operation threw. */
    SendStatus collect() { return fetch(true); }
    /** The same without waiting: SendNotReady before the end. */
    SendStatus collectIfDone() { return fetch(false); }
    /** True if an operation was sent and there is a variable for each of its values, or none at all. */
    bool ready() const;
    /** Throws if the arguments do not fit. */
    void check() const;
    /** Whether the destructor waits for the end; false at first. The operation completes either way. */
    void setAutoCollect(bool on) { auto_collect_ = on; }

    const Source& getSendHandleDataSource() const { return handle_; }
    const OperationInterfacePart* getOrp() const { return part_.get(); }

private:
    SendStatus fetch(bool wait);

    Source handle_;
    OperationInterfacePart::shared_constptr part_;
    std::string name_;
    OperationInterfacePart::Args arguments_;
    bool auto_collect_ = false;
};

}  // namespace internal
}  // namespace RTT

#endif
