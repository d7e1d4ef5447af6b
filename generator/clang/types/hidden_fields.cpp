// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "hidden_fields.hpp"

#include <algorithm>
#include <memory>

#include <clang/base/type_names.hpp>
#include <model/shown_name.hpp>

namespace oroforge::cxx {

namespace {

class MacroWatch : public clang::PPCallbacks {
public:
    explicit MacroWatch(bool& uses) : uses_(uses) {}

    void Ifdef(clang::SourceLocation, const clang::Token& name, const clang::MacroDefinition&) override { note(name); }
    void Ifndef(clang::SourceLocation, const clang::Token& name, const clang::MacroDefinition&) override { note(name); }
    void Defined(const clang::Token& name, const clang::MacroDefinition&, clang::SourceRange) override { note(name); }

private:
    void note(const clang::Token& token) {
        const clang::IdentifierInfo* name = token.getIdentifierInfo();
        if (name != nullptr && (name->getName() == "__orogen" || name->getName() == "__orogen2")) uses_ = true;
    }

    bool& uses_;
};

bool hasField(const Layout& layout, const std::string& name) {
    return std::any_of(layout.fields.begin(), layout.fields.end(),
                       [&](const auto& field) { return field.first == name; });
}

/// Returns the text about a field that only one layout has; nothing if the names are the same.
std::string missingField(const Layout& with, const Layout& without) {
    for (const auto& [name, bits] : without.fields)
        if (!hasField(with, name)) return ", and field '" + name + "' is only there";
    for (const auto& [name, bits] : with.fields)
        if (!hasField(without, name)) return ", and field '" + name + "' is only here";
    return "";
}

}  // namespace

Layouts layoutsOf(const clang::ASTContext& context, const std::vector<Root>& roots) {
    Layouts all;
    for (const Root& root : roots) {
        const auto* type = llvm::dyn_cast<clang::CXXRecordDecl>(root.type);
        const clang::CXXRecordDecl* definition = type != nullptr ? type->getDefinition() : nullptr;
        if (definition == nullptr || definition->isInvalidDecl() || definition->isDependentType()) continue;
        const auto name = nameOf(*definition);
        if (!name) continue;
        const clang::ASTRecordLayout& layout = context.getASTRecordLayout(definition);
        Layout& mine = all[name->cpp];
        mine.size = static_cast<std::uint64_t>(layout.getSize().getQuantity());
        mine.fields.clear();
        for (const clang::FieldDecl* field : definition->fields())
            mine.fields.emplace_back(field->getNameAsString(), layout.getFieldOffset(field->getFieldIndex()));
    }
    return all;
}

void watchForMacro(clang::Preprocessor& preprocessor, bool& uses) {
    preprocessor.addPPCallbacks(std::make_unique<MacroWatch>(uses));
}

void compareLayouts(const model::TypeModel& described, const Layouts& with, const Layouts& without, diag::Sink& sink) {
    for (const model::Struct& type : described.structs) {
        const auto here = with.find(type.cpp), there = without.find(type.cpp);
        if (here == with.end() || there == without.end()) continue;
        const Layout &mine = here->second, &other = there->second;
        if (mine.size == other.size && mine.fields == other.fields) continue;
        const std::string sizes = mine.size == other.size ? ""
                                                          : ": " + std::to_string(other.size) + " bytes there, " +
                                                                std::to_string(mine.size) + " here";
        sink.warning(type.where, "TK032",
                     "type '" + model::cppShown(type.cpp) +
                         "' is laid out in another way where __orogen is not defined" + sizes +
                         missingField(mine, other))
            .hint("hide what is not to be described by [[oro::skip]] instead: it stays in its place");
    }
}

}  // namespace oroforge::cxx
