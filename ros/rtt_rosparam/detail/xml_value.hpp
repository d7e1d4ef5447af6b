// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSPARAM_DETAIL_XML_VALUE_HPP
#define RTT_ROSPARAM_DETAIL_XML_VALUE_HPP

#include <xmlrpcpp/XmlRpcValue.h>

#include <string>

namespace rtt_rosparam {

/** What a value of the parameter server is, for messages: "a double (0.5)". */
std::string described(const XmlRpc::XmlRpcValue& value);

/** As ==, but a number that is NaN is the same as itself. */
bool same(const XmlRpc::XmlRpcValue& one, const XmlRpc::XmlRpcValue& other);

/** Of this type, whose C++ type is T. */
template <class T>
const T& as(const XmlRpc::XmlRpcValue& value) {
    return static_cast<const T&>(value);
}

}  // namespace rtt_rosparam

#endif
