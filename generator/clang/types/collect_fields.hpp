// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Collects the fields of a struct, including those of base classes and anonymous structs, with their offsets.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_COLLECT_FIELDS_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_COLLECT_FIELDS_HPP

#include <set>
#include <string>
#include <vector>

#include "classify.hpp"
#include "describe_type.hpp"
#include "field_forms.hpp"

namespace oroforge::cxx {

class FieldCollector {
public:
    explicit FieldCollector(TypeDescriber& types) : types_(types) {}

    void collect(const clang::CXXRecordDecl& type) { addRecord(type, 0); }

    const std::vector<model::Field>& fields() const { return fields_; }
    std::vector<Rejection> rejections() const;

    /// True if the type of a field is faulty, and that has been reported where the type is defined.
    bool broken() const { return broken_; }
    /// True if a field cannot be assigned.
    bool hasConstants() const { return hasConstants_; }

private:
    void addRecord(const clang::CXXRecordDecl& type, std::uint64_t offset);
    void addBase(const clang::CXXRecordDecl& type, const clang::CXXBaseSpecifier& base, std::uint64_t offset);
    void addWholeBase(const clang::CXXRecordDecl& type, const clang::CXXRecordDecl& base,
                      const clang::CXXBaseSpecifier& specifier, std::uint64_t offset);
    void addField(const clang::FieldDecl& field, std::uint64_t bits);
    void addUnnamedEnum(const clang::FieldDecl& field, const clang::EnumDecl& type);
    void addForm(const clang::FieldDecl& field, const FieldForm& form, std::uint64_t bits);
    void addPacked(const clang::FieldDecl& field, std::uint64_t offset);
    void addByCopy(const clang::FieldDecl& field, const std::string& name, const model::FieldAccess& access);
    /// Returns the added field, or a dummy if it was rejected.
    model::Field& addClassified(const clang::FieldDecl& field, const std::string& name, const Classified& type);
    bool usable(const clang::FieldDecl& field, const Classified& type);
    bool usable(const clang::FieldDecl& field, const clang::TagDecl& tag, const Classified& type);
    void reject(const clang::FieldDecl& field, Reason reason);
    void rejectName(const clang::FieldDecl& field);

    TypeDescriber& types_;
    std::vector<model::Field> fields_;
    std::vector<Rejection> rejections_;
    std::vector<Rejection> clashes_;  // faults of the whole struct, even if the field is in a base class
    std::set<std::string> names_;
    std::string base_;              // C++ name of the current base class
    clang::SourceLocation baseAt_;  // place where the struct names it
    bool broken_ = false;
    bool hasConstants_ = false;
    DocComment doc_;  // of the current field
};

}  // namespace oroforge::cxx

#endif
