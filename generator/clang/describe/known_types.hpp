// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Recognises classes and functions that components are made with.
#ifndef OROFORGE_GENERATOR_CLANG_DESCRIBE_KNOWN_TYPES_HPP
#define OROFORGE_GENERATOR_CLANG_DESCRIBE_KNOWN_TYPES_HPP

#include <string>

#include <clang/base/parse_files.hpp>

namespace oroforge::cxx {

/// Returns the name of an RTT class, such as TaskContext or InputPort; otherwise "".
std::string toolchainName(const clang::CXXRecordDecl& record);
/// Calls visit(class) for the class and for its base classes that are the user's, bases last.
template <class Visit>
void eachOwn(const clang::CXXRecordDecl& type, const Visit& visit) {
    if (isLibrary(type)) return;
    visit(type);
    for (const clang::CXXBaseSpecifier& base : type.bases()) {
        const auto* record = base.getType()->getAsCXXRecordDecl();
        if (record != nullptr && record->hasDefinition()) eachOwn(*record->getDefinition(), visit);
    }
}
/// True for std::shared_ptr, boost::intrusive_ptr … and iterators: their value is the place they point to.
bool isPointerLike(clang::QualType type);
bool isStdString(clang::QualType type);
/// True for std::vector, std::deque, std::list, which keep the order in which elements are added.
bool isSequence(clang::QualType type);
/// True for std::ostringstream and std::stringstream.
bool isTextStream(clang::QualType type);

/// Returns null if the body was not read.
const clang::FunctionDecl* definitionOf(const clang::FunctionDecl& function);

}  // namespace oroforge::cxx

#endif
