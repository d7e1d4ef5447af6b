// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_HANDLE_HPP
#define ORO_HANDLE_HPP

#include <rtt/internal/SignalBase.hpp>

namespace RTT {

/** Refers to one connection of a function to a signal. Copies refer to the same connection. Thread safe. */
class RTT_API Handle {
public:
    Handle() = default;
    explicit Handle(internal::SignalBase::ConnectionPtr connection);

    /** Has the function called again; false if the signal is gone or it is connected already. */
    bool connect();
    /** No call begins after this; one in another thread may still be ending. */
    bool disconnect();
    bool connected() const;
    /** True if there is a signal behind this handle. */
    bool ready() const;
    operator bool() const { return ready(); }
    bool operator!() const { return !ready(); }

protected:
    internal::SignalBase::ConnectionPtr connection_;
};

/** Disconnects when it goes out of scope. */
class RTT_API ScopedHandle : public Handle {
public:
    explicit ScopedHandle(const Handle& handle);
    ~ScopedHandle();
    ScopedHandle(const ScopedHandle&) = delete;
    ScopedHandle& operator=(const ScopedHandle&) = delete;
};

/** Owns the connection: the function is forgotten when this goes out of scope. */
class RTT_API CleanupHandle : public Handle {
public:
    CleanupHandle() = default;
    explicit CleanupHandle(const Handle& handle);
    ~CleanupHandle();
    CleanupHandle(const CleanupHandle&) = delete;
    CleanupHandle& operator=(const CleanupHandle&) = delete;
};

}  // namespace RTT

#endif
