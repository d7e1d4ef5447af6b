// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SIGNAL_HPP
#define ORO_SIGNAL_HPP

#include <rtt/Handle.hpp>

#include <boost/function.hpp>
#include <boost/shared_ptr.hpp>

namespace RTT {
namespace internal {

template <class Signature>
class Signal;

/** Calls all connected functions, in the thread that emits and in the order of connection. Functions may connect and
    disconnect while it emits; that counts from the next emission. Emitting is real-time safe if the functions are. */
template <class R, class... Args>
class Signal<R(Args...)> : public SignalBase {
public:
    typedef boost::function<void(Args...)> SlotFunction;  // results are ignored
    typedef boost::shared_ptr<Signal> shared_ptr;

    Handle connect(const SlotFunction& function) { return make(function, true); }
    /** The handle can connect it later. */
    Handle setup(const SlotFunction& function) { return make(function, false); }

    void emit(Args... args) const {
        if (auto all = this->snapshot())
            for (const ConnectionPtr& connection : *all)
                if (connection->connected()) static_cast<const Slot&>(*connection).function(args...);
    }
    void operator()(Args... args) const { emit(args...); }
    int arity() const override { return static_cast<int>(sizeof...(Args)); }

private:
    struct Slot : Connection {
        explicit Slot(const SlotFunction& f) : function(f) {}
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
