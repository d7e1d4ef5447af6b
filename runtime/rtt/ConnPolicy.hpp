// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// How two ports are connected: the storage between them, the threads that may use it, and the transport.
#ifndef ORO_CONN_POLICY_HPP
#define ORO_CONN_POLICY_HPP

#include <rtt/rtt-config.h>

#include <iosfwd>
#include <string>

namespace RTT {

/** The owner of the storage of a connection. */
enum BufferPolicy {
    UnspecifiedBufferPolicy = 0,  ///< the default: PerConnection
    PerConnection = 1,            ///< one for each connection
    PerInputPort = 2,             ///< one at the reader, filled by all its writers
    PerOutputPort = 3,            ///< one at the writer, emptied by all its readers: each sample is read once
    Shared = 4                    ///< one with a name, any number of writers and readers
};

RTT_API std::ostream& operator<<(std::ostream& os, BufferPolicy policy);
/** Reads an enumerator's name; any other word gives UnspecifiedBufferPolicy. */
RTT_API std::istream& operator>>(std::istream& is, BufferPolicy& policy);

/** Describes a connection or stream. Copying it is not real-time safe (strings). */
class RTT_API ConnPolicy {
public:
    static const int UNBUFFERED = -1;  ///< only for output streams of transports that need no storage
    static const int DATA = 0;
    static const int BUFFER = 1;
    static const int CIRCULAR_BUFFER = 2;

    static const int UNSYNC = 0;
    static const int LOCKED = 1;
    static const int LOCK_FREE = 2;

    static const bool PUSH = false;
    static const bool PULL = true;

    /** The process-wide template for default-constructed policies. Change it before threads use it. */
    static ConnPolicy& Default();

    static ConnPolicy buffer(int size, int lock_policy = LOCK_FREE, bool init_connection = false, bool pull = PUSH);
    static ConnPolicy circularBuffer(int size, int lock_policy = LOCK_FREE, bool init_connection = false,
                                     bool pull = PUSH);
    /** Unlike a default-constructed policy, this one initialises the connection. */
    static ConnPolicy data(int lock_policy = LOCK_FREE, bool init_connection = true, bool pull = PUSH);

    /** A copy of Default(), without its name_id. */
    ConnPolicy();
    /** Kept for old code; prefer the named factories. */
    explicit ConnPolicy(int type);
    ConnPolicy(int type, int lock_policy);

    int type;                     ///< DATA, BUFFER, CIRCULAR_BUFFER or UNBUFFERED
    int size;                     ///< capacity of a buffer in samples; with 0 every write fails
    int lock_policy;              ///< UNSYNC, LOCKED or LOCK_FREE
    bool init;                    ///< on connect, write the last written value into the connection
    bool pull;                    ///< PULL: storage at the writer's side; same behaviour inside one process
    int buffer_policy;            ///< a BufferPolicy
    int max_threads;              ///< threads that use a lock-free storage at once; 0: chosen from buffer_policy
    bool mandatory;               ///< a failure of this connection makes OutputPort::write() report failure
    int transport;                ///< 0: local, or the peer's default protocol
    mutable int data_size;        ///< bytes per sample, a hint for transports
    mutable std::string name_id;  ///< name of a stream, topic or shared connection

private:
    struct Builtin {};
    explicit ConnPolicy(Builtin);
};

/** For example `PUSH PerConnection LOCK_FREE BUFFER[10] (name_id=/chat)`. */
RTT_API std::ostream& operator<<(std::ostream& os, const ConnPolicy& policy);

namespace internal {
/** A ConnPolicy(), valid until this thread calls this again, so that code that makes ports need not make policies. */
RTT_API const ConnPolicy& policyOfPorts();
}  // namespace internal

}  // namespace RTT

#endif
