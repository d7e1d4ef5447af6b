// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Turns declarations into model::Struct and model::Enum, each type once, and reports unsuitable ones.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_DESCRIBE_TYPE_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_DESCRIBE_TYPE_HPP

#include <map>
#include <vector>

#include <clang/base/header_needs.hpp>
#include <clang/base/source_places.hpp>
#include <diag/sink.hpp>
#include <model/type_model.hpp>

#include "adapter_match.hpp"
#include "attributes.hpp"
#include "find_roots.hpp"
#include "rejection.hpp"

namespace oroforge::cxx {

/// The outcome for a type.
struct TypeFate {
    bool usable = true;                 ///< also while it is being described: a std::vector of itself is suitable
    std::vector<Rejection> rejections;  ///< why it is not usable, unless that was reported already
    bool isLeftOut = false;             ///< the user's own type is not a value, and perhaps nothing asks for it
    bool isSample = true;               ///< default constructible and assignable; else it is no element
};

class TypeDescriber {
public:
    TypeDescriber(clang::Sema& sema, const SourcePlaces& places, const Attributes& attributes,
                  const AdapterFinder& adapters, const HeaderNeeds& needs, bool strict, diag::Sink& sink,
                  model::TypeModel& into)
        : sema_(sema),
          places_(places),
          attributes_(attributes),
          adapters_(adapters),
          needs_(needs),
          strict_(strict),
          sink_(sink),
          into_(into) {}

    /// Describes the type and all types that it uses. Faults of types in the listed headers are reported at their
    /// fields, other faults at the field that uses the type. A class that is not a value is left out with a warning; it
    /// is an error if a field or port has that type, or in strict mode.
    const TypeFate& describe(const clang::CXXRecordDecl& type);
    const TypeFate& describe(const clang::EnumDecl& type);
    /// Also reports faults of a requested template instance, at the place of the request.
    void describe(const clang::CXXRecordDecl& type, const Root& root);

    clang::Sema& sema() const { return sema_; }
    const clang::ASTContext& context() const { return sema_.getASTContext(); }
    diag::Location locate(clang::SourceLocation at) const;
    void note(clang::SourceLocation at, const std::string& text) { into_.notes.push_back({locate(at), text, {}}); }
    /// Warns of names that are reserved for compilers and libraries.
    void checkName(const clang::NamedDecl& declaration, const std::string& subject);
    /// Returns the contents of comments and attributes.
    DocComment docOf(const clang::Decl& declaration) const;

    /// Reports a tag @ros of what is no struct.
    void refuseMessage(const DocComment& doc, clang::SourceLocation at, const std::string& subject);

    /// Returns the headers that the type needs.
    model::Homes homesOf(const clang::TagDecl& type) const { return needs_.homesOf(type); }

    /// True for the user's own types: written in a listed header, and not a template instance.
    bool isOwn(const clang::TagDecl& type) const;

    bool isLeftOut(const clang::CXXRecordDecl& type) { return describe(type).isLeftOut; }

    /// True if an adapter describes it.
    bool isAdapted(const clang::CXXRecordDecl& type) const { return adapters_.find(type).has_value(); }

private:
    const TypeFate& describeAdapted(const clang::CXXRecordDecl& type, const AdapterMatch& match, TypeFate& fate);
    void settle(const clang::TagDecl& type, std::vector<Rejection> found, bool broken, TypeFate& fate);
    void leaveOut(const clang::TagDecl& type, const TypeFate& fate);
    void checkPorts(const clang::CXXRecordDecl& type);
    void report(const Rejection& rejection, bool mayBeLeftOut = false);
    void addCauses(const Rejection& rejection, diag::Diagnostic& to) const;

    clang::Sema& sema_;
    const SourcePlaces& places_;
    const Attributes& attributes_;
    const AdapterFinder& adapters_;
    const HeaderNeeds& needs_;
    bool strict_;
    diag::Sink& sink_;
    model::TypeModel& into_;
    std::map<const clang::Decl*, TypeFate> fates_;  // only looked up, never iterated, so that pointer order cannot show
};

/// True if the type is a private or protected member of a class, so that other code cannot name it.
bool isHidden(const clang::TagDecl& type);

/// Makes the compiler complete a type that nothing has needed so far: a template instance that only a container names,
/// a scoped enum in an instance.
void complete(const clang::TagDecl& type, clang::Sema& sema, clang::SourceLocation at);

/// Returns faults of the whole type that show without its fields: linkage, unions, virtual functions.
std::vector<Rejection> checkType(const clang::TagDecl& type);

/// Properties of a type's values.
struct Nature {
    bool mayBeConstant = false;  ///< a member cannot be assigned, which is allowed
    bool isMade = false;         ///< the user gives an expression that makes a value
    bool assignable = true;      ///< result: the value can be assigned
};

/// Checks that other code can construct by default, copy and destroy values.
std::vector<Rejection> checkSpecialMembers(const clang::CXXRecordDecl& type, clang::Sema& sema, Nature& nature);

/// True if other code can copy and assign values.
bool isCopyable(const clang::CXXRecordDecl& type, clang::Sema& sema);

}  // namespace oroforge::cxx

#endif
