// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_STD_STRING_TYPE_INFO_HPP
#define ORO_STD_STRING_TYPE_INFO_HPP

#include "StdBasicStringTypeInfo.hpp"
#include <string>

namespace RTT {
namespace types {

/** Generator for std::string, registered as "string". */
struct StdStringTypeInfo : StdBasicStringTypeInfo<std::string> {
    explicit StdStringTypeInfo(const std::string& name = "string") : StdBasicStringTypeInfo<std::string>(name) {}
};

}  // namespace types
}  // namespace RTT

#endif
