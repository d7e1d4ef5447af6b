// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Turns a class with an adapter into model::Struct or model::Adapted, after checking every accessor.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_DESCRIBE_ADAPTED_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_DESCRIBE_ADAPTED_HPP

#include "accessor_check.hpp"
#include "adapter_match.hpp"
#include "classify.hpp"
#include "describe_type.hpp"

namespace oroforge::cxx {

class AdaptedDescriber {
public:
    AdaptedDescriber(TypeDescriber& types, const clang::CXXRecordDecl& type, const AdapterMatch& match,
                     diag::Sink& sink);

    /// Returns false after errors TK072 and TK073 at the lines of the adapter.
    bool describe(model::TypeModel& into);

private:
    /// How a part is read and written. `use` is not set after an error.
    struct Part {
        std::optional<model::TypeUse> use;
        model::FieldAccess access{model::AccessKind::Adapter};
    };

    model::Struct describeStruct();
    model::Adapted describeElements();
    Part part(const adapters::Accessor& get, const adapters::Accessor& set);
    bool isSettable(const adapters::Accessor& get, const adapters::Accessor& set, clang::QualType value, Part& part);
    std::optional<model::TypeUse> classify(const adapters::Accessor& accessor, clang::QualType type);
    /// Returns C++ for the number: digits, or text that follows the object.
    std::string size(const adapters::Accessor& accessor, bool& isNumber);
    std::string resize(const adapters::Accessor& accessor);
    /// The attribute "initial" and the elements <constructor>, in describe_constructors.cpp.
    std::string initial(const std::string& cpp);
    std::vector<model::Constructor> constructors(const std::string& cpp);
    std::optional<model::Constructor> constructor(const adapters::Constructor& given, const std::string& cpp);
    std::optional<clang::QualType> typeOf(const adapters::Constructor::Argument& argument);
    void addNames(model::TypeModel& into, const std::string& registry);
    diag::Diagnostic& fail(const adapters::Accessor& accessor, const char* code, const std::string& what);

    TypeDescriber& types_;
    const clang::CXXRecordDecl& type_;
    const AdapterMatch& match_;
    const adapters::Adapter& adapter_;
    diag::Sink& sink_;
    AccessorCheck check_;
    std::string subject_;  ///< in messages
    bool sound_ = true;
};

}  // namespace oroforge::cxx

#endif
