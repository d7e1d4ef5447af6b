// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_INTERNAL_FLOW_STREAM_SENDER_HPP
#define ORO_INTERNAL_FLOW_STREAM_SENDER_HPP

namespace RTT {
namespace internal {

/** The element of a transport that sends into a stream, which receivers find by its name. */
class StreamSender {
public:
    virtual ~StreamSender() = default;
    /** No other receiver is to find the stream: its name can go. So nothing stays when this process is killed. */
    virtual void withdrawName() = 0;
};

}  // namespace internal
}  // namespace RTT

#endif
