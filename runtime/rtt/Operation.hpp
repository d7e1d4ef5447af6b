// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OPERATION_HPP
#define ORO_OPERATION_HPP

#include <rtt/base/OperationBase.hpp>
#include <rtt/internal/LocalOperationCaller.hpp>
#include <rtt/internal/Signal.hpp>
#include <rtt/internal/calls/operation_table.hpp>
#include <rtt/internal/calls/signature.hpp>

namespace RTT {

template <class Signature>
class Operation;

/**
 * A function that a component offers to others, with a name and documentation. Belongs to the component. Set the
 * function before addOperation(); callers made before a later calls() keep the old one. Not thread safe.
 */
template <class R, class... Args>
class Operation<R(Args...)> : public base::OperationBase {
public:
    typedef R Signature(Args...);
    typedef boost::shared_ptr<Operation> shared_ptr;

    /** Without a function; call calls() later. */
    explicit Operation(const std::string& name)
        : OperationBase(name, new internal::LocalOperationCaller<Signature>(),
                        internal::OperationTableOf<Signature>::table) {}
    template <class Function, std::enable_if_t<!std::is_member_function_pointer_v<Function>, int> = 0>
    Operation(const std::string& name, Function function, ExecutionThread et = ClientThread,
              ExecutionEngine* ownerEngine = nullptr)
        : Operation(name) {
        calls(std::move(function), et, ownerEngine);
    }
    template <class Function, class Object, std::enable_if_t<std::is_member_function_pointer_v<Function>, int> = 0>
    Operation(const std::string& name, Function function, Object object, ExecutionThread et = ClientThread,
              ExecutionEngine* ownerEngine = nullptr)
        : Operation(name) {
        calls(function, object, et, ownerEngine);
    }
    Operation(const Operation& other) : OperationBase(other) {}
    Operation& operator=(const Operation& other) {
        OperationBase::operator=(other);
        return *this;
    }

    Operation& doc(const std::string& description) {
        this->setDoc(description);
        return *this;
    }
    /** Documents the next argument. */
    Operation& arg(const std::string& name, const std::string& description) {
        this->addArgument(name, description);
        return *this;
    }

    /** Sets the function; in OwnThread it is executed by `ownerEngine`, which addOperation() sets too. */
    template <class Function, std::enable_if_t<!std::is_member_function_pointer_v<Function>, int> = 0>
    Operation& calls(Function function, ExecutionThread et = ClientThread, ExecutionEngine* ownerEngine = nullptr) {
        this->setFunction(internal::makeCallee<Signature>(std::move(function)), et, ownerEngine);
        return *this;
    }
    template <class Function, class Object, std::enable_if_t<std::is_member_function_pointer_v<Function>, int> = 0>
    Operation& calls(Function function, Object object, ExecutionThread et = ClientThread,
                     ExecutionEngine* ownerEngine = nullptr) {
        return calls(internal::BoundMember<Function, Object>{function, object}, et, ownerEngine);
    }

    /** Makes this also a signal: subscribed functions are called with the arguments before the operation is. */
    Operation& signals() {
        listeners();
        return *this;
    }
    template <class Function, std::enable_if_t<!std::is_member_function_pointer_v<Function>, int> = 0>
    Handle signals(Function function) {
        return listeners().connect(function);
    }
    template <class Function, class Object, std::enable_if_t<std::is_member_function_pointer_v<Function>, int> = 0>
    Handle signals(Function function, Object object) {
        return listeners().connect(internal::BoundMember<Function, Object>{function, object});
    }

    /** The signal itself: `signal->connect(function)`, `signal->emit(arguments)`. Converts to true if signals() was
        called, which any use does. */
    class Listeners {
    public:
        explicit Listeners(Operation& operation) : operation_(operation) {}
        Listeners(const Listeners&) = delete;
        Listeners& operator=(const Listeners&) = delete;
        explicit operator bool() const { return operation_.hasFunction() && operation_.caller()->callee()->signal(); }
        internal::Signal<void(Args...)>* get() const { return &operation_.listeners(); }
        internal::Signal<void(Args...)>* operator->() const { return get(); }
        internal::Signal<void(Args...)>& operator*() const { return *get(); }
        Handle connect(const boost::function<void(Args...)>& function) const { return get()->connect(function); }

    private:
        Operation& operation_;
    };
    const Listeners signal{*this};

    boost::shared_ptr<internal::LocalOperationCaller<Signature>> getOperationCaller() const {
        return boost::shared_ptr<internal::LocalOperationCaller<Signature>>(this->implementation(), caller());
    }

private:
    typedef internal::Signal<void(Args...)> OperationSignal;

    internal::LocalOperationCaller<Signature>* caller() const {
        return static_cast<internal::LocalOperationCaller<Signature>*>(this->implementation().get());
    }
    OperationSignal& listeners() {
        // An operation without a function is only a signal.
        if (!this->hasFunction()) calls([](Args...) -> R { return internal::NA<R>::na(); });
        internal::CalleeBase& callee = *caller()->callee();
        if (!callee.signal()) callee.listen(std::make_shared<OperationSignal>());
        return static_cast<OperationSignal&>(*callee.signal());
    }
};

}  // namespace RTT

#endif
