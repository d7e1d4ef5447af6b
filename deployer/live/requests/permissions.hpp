// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_PERMISSIONS_HPP
#define OROFORGE_LIVE_PERMISSIONS_HPP

#include "found_value.hpp"
#include "verbs.hpp"

#include <string>

namespace OCL::live {

/** Operations must not be a way around the other permissions, nor to the files and programs of the computer. Why the
    caller may not call what the path leads to; empty if it may. */
std::string whyNotCalled(const Asked& asked, const Found& at);
/** Throws Failure if the caller may not set this property, because it is code or says where code comes from. */
void checkSet(const Asked& asked, const FoundValue& found);

}  // namespace OCL::live

#endif
