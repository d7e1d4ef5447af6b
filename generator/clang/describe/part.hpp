// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The references that all parts which follow a constructor share.
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

/// Reads the resulting interface, with the values of variables at the end of the constructor.
void readResult(const Part& parts, Followed& made);
/// Follows functions that the constructor does not call, and reports what they would add.
void followLate(const Part& parts, const clang::CXXRecordDecl& made);

}  // namespace oroforge::cxx

#endif
