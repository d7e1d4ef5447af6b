// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "sound_types.hpp"

namespace oroforge::cxx {

bool SoundTypes::has(const clang::TagDecl& type) {
    // A type that contains itself, in a std::vector, is sound unless something else is wrong.
    const auto [entry, isNew] = known_.try_emplace(type.getCanonicalDecl(), true);
    if (!isNew) return entry->second;
    return known_[type.getCanonicalDecl()] = isSound(type);
}

bool SoundTypes::isSound(const clang::TagDecl& type) {
    // A missing definition may be due to the error.
    const clang::TagDecl* definition = type.getDefinition();
    if (definition == nullptr || definition->isInvalidDecl() || definition->isDependentType()) return false;
    const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(definition);
    if (record == nullptr) return true;
    if (const auto* instance = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record)) {
        for (const clang::TemplateArgument& argument : instance->getTemplateArgs().asArray()) {
            if (argument.getKind() == clang::TemplateArgument::Type && !hasType(argument.getAsType())) return false;
        }
    }
    for (const clang::CXXBaseSpecifier& base : record->bases()) {
        if (!hasType(base.getType())) return false;
    }
    for (const clang::Decl* member : record->decls()) {
        if (member->isInvalidDecl()) return false;
        const auto* field = llvm::dyn_cast<clang::FieldDecl>(member);
        if (field != nullptr && !hasType(field->getType())) return false;
    }
    return true;
}

bool SoundTypes::hasType(clang::QualType type) {
    if (type.isNull() || type->containsErrors() || type->isDependentType() || type->isUndeducedType()) return false;
    if (const clang::Type* element = type->getBaseElementTypeUnsafe(); element->getAsTagDecl() != nullptr) {
        return has(*element->getAsTagDecl());
    }
    return true;
}

}  // namespace oroforge::cxx
