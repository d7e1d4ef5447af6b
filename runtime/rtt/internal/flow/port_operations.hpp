// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The operations of ports that take or give samples. Every port of every component has them, so as little of them as
// possible is a template.
#ifndef ORO_INTERNAL_PORT_OPERATIONS_HPP
#define ORO_INTERNAL_PORT_OPERATIONS_HPP

#include <rtt/internal/calls/operation_table.hpp>
#include <rtt/internal/flow/port_sources.hpp>

namespace RTT {
class Service;
namespace base {
class OperationBase;
}
namespace internal {

/** The function of a port's operations. May outlive the port. */
class RTT_API PortCallee final : public CalleeBase {
public:
    explicit PortCallee(const base::PortInterface& port) : link_(port) {}
    ~PortCallee() override;
    static const PortLink& linkOf(const base::OperationCallerInterface& caller) {
        return static_cast<const PortCallee*>(caller.callee())->link_;
    }

private:
    const PortLink link_;
};

template <class Signature>
class PortCaller;
/** Calls in the thread of the caller; cannot be sent. */
template <class R, class... Args>
class PortCaller<R(Args...)> final : public base::OperationCallerBase<R(Args...)> {
public:
    PortCaller() = default;
    R call(Args... sample) override { return callPort(PortCallee::linkOf(*this), sample...); }
    SendHandle<R(Args...)> send(Args...) override { return SendHandle<R(Args...)>(); }
    PortCaller* cloneI(ExecutionEngine* caller) const override { return new PortCaller(*this, caller); }

private:
    PortCaller(const PortCaller& other, ExecutionEngine* caller)
        : base::OperationCallerBase<R(Args...)>(other, caller) {}
    template <class T>
    static FlowStatus callPort(const PortLink& port, T& sample) {
        return port.read(std::addressof(sample));
    }
    template <class T>
    static WriteStatus callPort(const PortLink& port, const T& sample) {
        return port.write(std::addressof(sample));
    }
    static R callPort(const PortLink& port) {
        R sample = R();
        port.last(std::addressof(sample));
        return sample;
    }
};

/** The part of the tables below that is common to all types. */
class RTT_API PortOperation {
public:
    /** These add "read", "write" or "last" to the service of `port`. They take ownership of `caller`. */
    static void addRead(Service& object, base::PortInterface& port, base::OperationCallerInterface* caller,
                        const OperationTable& table);
    static void addWrite(Service& object, base::PortInterface& port, base::OperationCallerInterface* caller,
                         const OperationTable& table);
    static void addLast(Service& object, base::PortInterface& port, base::OperationCallerInterface* caller,
                        const OperationTable& table);

    static void invokeRead(base::OperationCallerInterface& caller, void* const* arguments, void* result);
    static void invokeWrite(base::OperationCallerInterface& caller, void* const* arguments, void* result);
    static SentCall::shared_ptr refuse(base::OperationCallerInterface& caller, void* const* arguments);
    static base::DataSourceBase* makeRead(GenericCall&& call);
    static base::DataSourceBase* makeWrite(GenericCall&& call);

private:
    static void add(Service& object, base::PortInterface& port, base::OperationBase* operation);
};

template <class T>
struct PortTables {
    static base::DataSourceBase* makeLast(GenericCall&& call) {
        return makePortSource<T>(PortCallee::linkOf(call.caller()), true);
    }
    static constexpr ValueType readTypes[] = {valueType<FlowStatus>(), valueType<T&>()};
    static constexpr ValueType writeTypes[] = {valueType<WriteStatus>(), valueType<const T&>()};
    static constexpr ValueType lastTypes[] = {valueType<T>()};
    static constexpr OperationTable read = {1,
                                            readTypes,
                                            &PortOperation::invokeRead,
                                            &PortOperation::refuse,
                                            &PortOperation::makeRead,
                                            &typeid(TypedCall<FlowStatus(T&)>)};
    static constexpr OperationTable write = {1,
                                             writeTypes,
                                             &PortOperation::invokeWrite,
                                             &PortOperation::refuse,
                                             &PortOperation::makeWrite,
                                             &typeid(TypedCall<WriteStatus(const T&)>)};
    // No invoke function: its sources ask the port themselves.
    static constexpr OperationTable last = {
        0, lastTypes, nullptr, &PortOperation::refuse, &makeLast, &typeid(TypedCall<T()>)};
};

}  // namespace internal
}  // namespace RTT

#endif
