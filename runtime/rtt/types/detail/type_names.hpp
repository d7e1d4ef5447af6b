// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TYPE_NAMES_HPP
#define ORO_TYPE_NAMES_HPP

#include <string>

namespace RTT {
namespace types {

namespace detail {
/** "/std/vector</double>" as "std.vector<double>", the form of scripts and displays. */
std::string dottedName(const std::string& name);
/** "pkg.Type" as "/pkg/Type", and "pkg.Box<pkg.Type>" as "/pkg/Box</pkg/Type>". */
std::string slashedName(const std::string& name);
}  // namespace detail

}  // namespace types
}  // namespace RTT

#endif
