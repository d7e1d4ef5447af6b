// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Asks the compiler what an accessor means for a class, as if the expression were in the source.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_ACCESSOR_CHECK_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_ACCESSOR_CHECK_HPP

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <adapters/accessor.hpp>
#include <clang/base/llvm_compat.hpp>

namespace oroforge::cxx {

/// The expression that an accessor makes, or the error that it causes.
struct Accessed {
    clang::Expr* expression = nullptr;
    std::string error;  ///< in the compiler's words

    /// The type without reference, const and volatile.
    clang::QualType valueType() const;
    /// True if it is an object of that type that can be changed and has an address.
    bool isPlace() const;
};

class AccessorCheck {
public:
    AccessorCheck(clang::Sema& sema, const clang::CXXRecordDecl& type);
    ~AccessorCheck();
    AccessorCheck(const AccessorCheck&) = delete;
    AccessorCheck& operator=(const AccessorCheck&) = delete;

    /// Sets more arguments that calls may have.
    void setWords(std::map<std::string, clang::QualType> words) { words_ = std::move(words); }

    /// Returns why a call of the constructor with these arguments fails; empty if it does not.
    std::string construct(const std::vector<clang::QualType>& arguments);

    /// Returns why the accessor makes no value of the class; it must call a static function that returns one.
    std::string makesValue(const Accessed& made);

    /// Uses a const object if it is only read. "value" is an argument of type `value`, all others are std::size_t.
    Accessed access(const adapters::Accessor& accessor, bool isConst, clang::QualType value = {});

    /// Returns why a value of that type cannot be assigned to it; empty if it can. Assigning to a copy is a fault, too.
    std::string assign(const Accessed& target, clang::QualType value);

private:
    class FirstError;
    clang::Expr* makeObject(clang::QualType type);
    clang::ExprResult apply(clang::Expr* base, const adapters::Step& step, clang::QualType value);

    clang::Sema& sema_;
    clang::ASTContext& context_;
    clang::QualType type_;
    clang::SourceLocation at_;
    std::map<std::string, clang::QualType> words_;
};

}  // namespace oroforge::cxx

#endif
