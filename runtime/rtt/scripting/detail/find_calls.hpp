// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_SCRIPTING_DETAIL_FIND_CALLS_HPP
#define ORO_SCRIPTING_DETAIL_FIND_CALLS_HPP

#include <rtt/scripting/detail/ast.hpp>

namespace RTT {
namespace scripting {
namespace detail {

/** False if the statement calls no operation or function for sure; constructors of known types are none. */
bool mayCall(const ast::Statement& statement);

}  // namespace detail
}  // namespace scripting
}  // namespace RTT

#endif
