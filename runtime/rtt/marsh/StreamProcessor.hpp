// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_STREAM_PROCESSOR_HPP
#define ORO_STREAM_PROCESSOR_HPP

namespace RTT {
namespace marsh {

/** Base of marshallers that write to a stream, which must outlive them. */
template <typename output_stream>
class StreamProcessor {
protected:
    output_stream* s;

public:
    explicit StreamProcessor(output_stream& stream) : s(&stream) {}
};

}  // namespace marsh
}  // namespace RTT

#endif
