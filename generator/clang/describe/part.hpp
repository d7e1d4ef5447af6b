// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What each class that takes part in following a constructor may use.
#ifndef OROFORGE_GENERATOR_CLANG_DESCRIBE_PART_HPP
#define OROFORGE_GENERATOR_CLANG_DESCRIBE_PART_HPP

#include "call_stack.hpp"
#include "memory.hpp"
#include "registry.hpp"

namespace oroforge::cxx {

class Statements;
class Expressions;
class Calls;
class Objects;
class Texts;
class Containers;
class KnownObjects;
class InterfaceCalls;

using Values = std::vector<Value>;

struct Part {
    clang::ASTContext& context_;
    Findings& findings_;
    Memory& memory_;
    CallStack& stack_;
    Registry& registry_;
    Statements& statements_;
    Expressions& values_;
    Calls& calls_;
    Objects& objects_;
    Texts& texts_;
    Containers& containers_;
    KnownObjects& known_;
    InterfaceCalls& interface_;
};

/// The interface that came out of it, with the values that variables have at the end of the constructor.
void readResult(const Part& parts, Followed& made);
/// Functions that the constructor does not call: tells what they would add.
void followLate(const Part& parts, const clang::CXXRecordDecl& made);

}  // namespace oroforge::cxx

#endif
