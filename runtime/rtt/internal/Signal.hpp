// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SIGNAL_HPP
#define ORO_SIGNAL_HPP

#include <rtt/Handle.hpp>

#include <boost/function.hpp>
#include <boost/shared_ptr.hpp>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

namespace RTT {
namespace internal {

template <class Signature>
class Signal;

/** Calls all connected functions, in the emitting thread and in order of connection. Functions may connect and
    disconnect meanwhile; new ones are called from the next emission on. Real-time safe if the functions are. */
template <class R, class... Args>
class Signal<R(Args...)> : public SignalBase {
public:
    typedef boost::function<void(Args...)> SlotFunction;  // results are ignored
    typedef boost::shared_ptr<Signal> shared_ptr;

    Handle connect(const SlotFunction& function) { return make(function, true); }
    /** The handle can connect it later. */
    Handle setup(const SlotFunction& function) { return make(function, false); }

    void emit(Args... args) const {
        void* const all[] = {const_cast<void*>(static_cast<const volatile void*>(std::addressof(args)))..., nullptr};
        this->emitErased(all);
    }
    void operator()(Args... args) const { emit(args...); }
    int arity() const override { return static_cast<int>(sizeof...(Args)); }

private:
    // Each function gets its own value, so an argument that would be moved from is copied.
    template <class Arg>
    using Passed = std::conditional_t<std::is_rvalue_reference_v<Arg>, std::decay_t<Arg>, Arg>;
    struct Slot final : Connection {
        explicit Slot(const SlotFunction& f) : function(f) {}
        void call(void* const* arguments) const override { callWith(arguments, std::index_sequence_for<Args...>()); }
        template <std::size_t... I>
        void callWith(void* const* arguments, std::index_sequence<I...>) const {
            (void)arguments;
            function(static_cast<Passed<Args>>(
                *static_cast<std::remove_cv_t<std::remove_reference_t<Args>>*>(arguments[I]))...);
        }
        SlotFunction function;
    };
    Handle make(const SlotFunction& function, bool connect) {
        ConnectionPtr connection = std::make_shared<Slot>(function);
        this->add(connection, connect);
        return Handle(connection);
    }
};

}  // namespace internal
}  // namespace RTT

#endif
