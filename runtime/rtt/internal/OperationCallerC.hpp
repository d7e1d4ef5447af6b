// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OPERATION_CALLER_C_HPP
#define ORO_OPERATION_CALLER_C_HPP

#include <rtt/internal/SendHandleC.hpp>

namespace RTT {
namespace internal {

/**
 * Calls an operation whose signature is known only at run time. Give it all arguments first: `OperationCallerC(part,
 * "add", engine).argC(2).arg(x).ret(sum).call()`. Like an OperationCaller, it keeps calling the operation that it was
 * made for when that is removed or replaced. The second and later calls are real-time safe if the operation is.
 */
class RTT_API OperationCallerC {
public:
    typedef base::DataSourceBase::shared_ptr Source;

    OperationCallerC() = default;
    /** `name` is for messages only. With a null `part` it is never ready. */
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

    /** Where call() puts the result, converted if the types allow that. */
    OperationCallerC& ret(Source variable);
    OperationCallerC& ret(base::AttributeBase* attribute);
    template <class T>
    OperationCallerC& ret(T& variable) {
        return ret(Source(new ReferenceDataSource<T>(variable)));
    }

    /** False, with an error logged and without a call, if the arguments do not fit or one of them cannot be evaluated.
        Throws what the operation throws. */
    bool call();
    /** The same, but then gives a handle that is not ready. */
    SendHandleC send();
    /** True if the arguments fit. */
    bool ready() const;
    /** Throws if the arguments do not fit, see FactoryExceptions.hpp. */
    void check() const;

    /** The source whose evaluation calls, or sends; null if the arguments do not fit. */
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
