// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_HANDLE_HPP
#define ORO_HANDLE_HPP

#include <rtt/internal/SignalBase.hpp>

namespace RTT {

/** Refers to a subscription of a function to a signal. Copies refer to the same one. Thread safe. */
class RTT_API Handle {
public:
    Handle() = default;
    explicit Handle(internal::SignalBase::ConnectionPtr connection);

    /** Renews the subscription; false if the signal is gone or it is connected already. */
    bool connect();
    /** No call begins after this; one in another thread may still be in progress. */
    bool disconnect();
    bool connected() const;
    /** True if the handle belongs to a signal. */
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

/** Owns the subscription: ends it for good when this goes out of scope. */
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
