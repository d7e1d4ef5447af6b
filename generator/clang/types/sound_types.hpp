// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds out which types can still be judged in a text with compile errors.
#ifndef OROFORGE_GENERATOR_CLANG_TYPES_SOUND_TYPES_HPP
#define OROFORGE_GENERATOR_CLANG_TYPES_SOUND_TYPES_HPP

#include <map>

#include <clang/base/llvm_compat.hpp>

namespace oroforge::cxx {

class SoundTypes {
public:
    /// True if no error affects the type or a type that it contains: then statements about it are right.
    bool has(const clang::TagDecl& type);

private:
    bool isSound(const clang::TagDecl& type);
    bool hasType(clang::QualType type);
    std::map<const clang::Decl*, bool> known_;  // looked up only
};

}  // namespace oroforge::cxx

#endif
