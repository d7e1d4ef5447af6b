// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Topics of plain types: a port of double is one of std_msgs/Float64, of std::vector<double> one of Float64MultiArray.
#include "primitive_messages.hpp"

namespace std_msgs {

namespace {

class PrimitivesTransport : public rtt_roscomm::MessageTransport {
public:
    PrimitivesTransport() : MessageTransport("primitives", primitiveMessages().first, primitiveMessages().count) {}
};

}  // namespace

}  // namespace std_msgs

ORO_TYPEKIT_PLUGIN(std_msgs::PrimitivesTransport)
