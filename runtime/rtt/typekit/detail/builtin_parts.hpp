// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The parts of the built-in typekit, one file each, called once, when it is loaded.
#ifndef ORO_BUILTIN_PARTS_HPP
#define ORO_BUILTIN_PARTS_HPP

namespace RTT {
namespace types {
namespace builtin {

void addFundamentalTypes();
void addSmallNumbers();
void addTexts();
void addBags();
void addStatusTypes();
void addPolicies();
void addComponentTypes();
void addNumberConversions();
void addOtherConversions();
void addNumberOperators();
void addTextOperators();
void addGlobals();

}  // namespace builtin
}  // namespace types
}  // namespace RTT

#endif
