// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OCL_LUA_READ_SIGNATURE_HPP
#define OCL_LUA_READ_SIGNATURE_HPP

#include <rtt/internal/calls/operation_signature.hpp>

#include <string>

namespace OCL::lua {

/** Reads a signature as C++ writes it, such as "double(double x, const string& name)"; the names may be missing. Throws
    Failure. */
RTT::internal::OperationSignature readSignature(const std::string& text);

}  // namespace OCL::lua

#endif
