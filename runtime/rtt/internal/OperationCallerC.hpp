// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OPERATION_CALLER_C_HPP
#define ORO_OPERATION_CALLER_C_HPP

#include <rtt/internal/SendHandleC.hpp>

namespace RTT {
namespace internal {

/**
 * Calls an operation whose signature is known at run time only. Give it all arguments first:
 * `OperationCallerC(part, "add", engine).argC(2).arg(x).ret(sum).call()`. Keeps what it was made for when the operation is
 * removed or replaced, as OperationCaller does. Real-time safe: calling again what was
 * called before, if the operation is.
 */
class RTT_API OperationCallerC {
public:
    typedef base::DataSourceBase::shared_ptr Source;

    OperationCallerC() = default;
    /** `name` is for messages only. Null is allowed: not ready then. */
    OperationCallerC(const OperationInterfacePart* part, const std::string& name, ExecutionEngine* caller);
    ~OperationCallerC();
    OperationCallerC(const OperationCallerC&) = default;
    OperationCallerC& operator=(const OperationCallerC&) = default;

    /** The next argument: a source, which is evaluated with each call; a constant; a variable. */
    OperationCallerC& arg(Source argument);
    template <class T>
    OperationCallerC& argC(const T& constant) {
        return arg(Source(new ConstantDataSource<T>(constant)));
    }
    template <class T>
    OperationCallerC& arg(T& variable) {
        return arg(Source(new ReferenceDataSource<T>(variable)));
    }

    /** Where call() puts the result; converted if the types know how. */
    OperationCallerC& ret(Source variable);
    OperationCallerC& ret(base::AttributeBase* attribute);
    template <class T>
    OperationCallerC& ret(T& variable) {
        return ret(Source(new ReferenceDataSource<T>(variable)));
    }

    /** False, and an error, if something is wrong with the arguments or one of them cannot be evaluated; the operation is not
        called then. Throws what the operation throws. */
    bool call();
    /** As above; the handle is not ready then. */
    SendHandleC send();
    /** True if call() can be called. */
    bool ready() const;
    /** Throws what is wrong with the arguments, see FactoryExceptions.hpp. */
    void check() const;

    /** The source whose evaluation calls, or sends; null if something is wrong. */
    Source getCallDataSource();
    Source getSendDataSource();
    const OperationInterfacePart* getOrp() const { return part_.get(); }

private:
    bool prepare();

    OperationInterfacePart::shared_constptr part_;
    std::string name_;
    ExecutionEngine* caller_ = nullptr;
    OperationInterfacePart::Args arguments_;
    Source result_, call_;
    boost::shared_ptr<base::ActionInterface> store_result_;  // calls, then assigns
};

}  // namespace internal
}  // namespace RTT

#endif
