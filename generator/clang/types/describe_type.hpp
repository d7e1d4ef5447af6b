// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Turns declarations into model::Struct and model::Enum, each type once, and reports what cannot be turned.
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

/// What became of a type.
struct TypeFate {
    bool usable = true;                 ///< also while it is being described: a std::vector of itself is fine
    std::vector<Rejection> rejections;  ///< why not, unless that was reported already
    bool isLeftOut = false;             ///< of the user's own types: it is no value, and nobody may have asked for it
    bool isSample = true;               ///< default constructible and assignable; else no element of anything
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

    /// Describes the type and all it uses. Faults of types in the listed headers are reported at their fields;
    /// those of other types are handed to the field that uses them. A class that is no value is left out with a warning;
    /// it is an error where a field or a port is of that type, or if the user wants it so.
    const TypeFate& describe(const clang::CXXRecordDecl& type);
    const TypeFate& describe(const clang::EnumDecl& type);
    /// Of a template instance that is asked for, too, faults are reported: where that is done.
    void describe(const clang::CXXRecordDecl& type, const Root& root);

    clang::Sema& sema() const { return sema_; }
    const clang::ASTContext& context() const { return sema_.getASTContext(); }
    diag::Location locate(clang::SourceLocation at) const;
    void note(clang::SourceLocation at, const std::string& text) { into_.notes.push_back({locate(at), text, {}}); }
    /// Warns of names that belong to compilers and libraries.
    void checkName(const clang::NamedDecl& declaration, const std::string& subject);
    /// What comments and attributes say of it.
    DocComment docOf(const clang::Decl& declaration) const;

    /// The headers that the type needs.
    model::Homes homesOf(const clang::TagDecl& type) const { return needs_.homesOf(type); }

    /// Whether it is the user's own: written in a listed header and no template instance.
    bool isOwn(const clang::TagDecl& type) const;

    bool isLeftOut(const clang::CXXRecordDecl& type) { return describe(type).isLeftOut; }

    /// Whether an adapter says what it consists of.
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
    std::map<const clang::Decl*, TypeFate> fates_;  // looked up only; never iterated, so pointer order cannot show
};

/// Whether the type is a private or protected member of a class, so that nobody else can name it.
bool isHidden(const clang::TagDecl& type);

/// Has the compiler make the definition of what nobody needed so far: a template instance that only a container names, a
/// scoped enum in an instance.
void complete(const clang::TagDecl& type, clang::Sema& sema, clang::SourceLocation at);

/// Faults of the type as a whole that show before its fields are looked at: linkage, unions, virtual functions.
std::vector<Rejection> checkType(const clang::TagDecl& type);

/// What values of a type are like.
struct Nature {
    bool mayBeConstant = false;  ///< a member cannot be assigned, and that is all right
    bool isMade = false;         ///< the user says how a value is made
    bool assignable = true;      ///< the answer
};

/// Default construction, copying and destruction by anybody.
std::vector<Rejection> checkSpecialMembers(const clang::CXXRecordDecl& type, clang::Sema& sema, Nature& nature);

/// Whether everybody may make a copy of a value and assign it.
bool isCopyable(const clang::CXXRecordDecl& type, clang::Sema& sema);

}  // namespace oroforge::cxx

#endif
