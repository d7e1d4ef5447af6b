// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Asks the compiler what an accessor means for a class, as if the expression stood in the source.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_ACCESSOR_CHECK_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_ACCESSOR_CHECK_HPP

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <adapters/accessor.hpp>
#include <clang/base/llvm_compat.hpp>

namespace oroforge::cxx {

/// The expression that an accessor makes, or why it makes none.
struct Accessed {
    clang::Expr* expression = nullptr;
    std::string error;  ///< the compiler's words

    /// Without reference, const and volatile.
    clang::QualType valueType() const;
    /// An object of that type that may be changed, and has an address.
    bool isPlace() const;
};

class AccessorCheck {
public:
    AccessorCheck(clang::Sema& sema, const clang::CXXRecordDecl& type);
    ~AccessorCheck();
    AccessorCheck(const AccessorCheck&) = delete;
    AccessorCheck& operator=(const AccessorCheck&) = delete;

    /// Further arguments that calls may have.
    void setWords(std::map<std::string, clang::QualType> words) { words_ = std::move(words); }

    /// Why such a call of its constructor makes no value; empty if it does.
    std::string construct(const std::vector<clang::QualType>& arguments);

    /// Why what was accessed is no value that everybody can make: by a static function, of the class or of what becomes one.
    std::string makesValue(const Accessed& made);

    /// Of a const object if it is only to be read. "value" is an argument of type `value`, all others are std::size_t.
    Accessed access(const adapters::Accessor& accessor, bool isConst, clang::QualType value = {});

    /// Why a value of that type cannot be assigned to it; empty if it can. Also not, if that would change a copy only.
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
