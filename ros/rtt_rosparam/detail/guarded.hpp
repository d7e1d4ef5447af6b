// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSPARAM_DETAIL_GUARDED_HPP
#define RTT_ROSPARAM_DETAIL_GUARDED_HPP

#include "failure.hpp"

#include <xmlrpcpp/XmlRpcException.h>

#include <exception>
#include <string>

namespace rtt_rosparam {

/** Calls the function; the text of what it throws, or "". */
template <class Function>
std::string problemIn(Function function) {
    try {
        function();
        return "";
    } catch (const XmlRpc::XmlRpcException& error) {  // is no std::exception
        return "XML-RPC: " + error.getMessage();
    } catch (const std::exception& error) {
        const std::string text = error.what();
        return text.empty() ? "unknown error" : text;
    }
}

}  // namespace rtt_rosparam

#endif
