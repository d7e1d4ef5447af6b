// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Classes and functions that a component is made with, by what they are.
#ifndef OROFORGE_GENERATOR_CLANG_DESCRIBE_KNOWN_TYPES_HPP
#define OROFORGE_GENERATOR_CLANG_DESCRIBE_KNOWN_TYPES_HPP

#include <string>

#include <clang/base/parse_files.hpp>

namespace oroforge::cxx {

/// Name of a class of RTT, or "": TaskContext, InputPort …
std::string toolchainName(const clang::CXXRecordDecl& record);
/// Calls visit(class) for the class and for those of the user's that it is derived from, bases last.
template <class Visit>
void eachOwn(const clang::CXXRecordDecl& type, const Visit& visit) {
    if (isLibrary(type)) return;
    visit(type);
    for (const clang::CXXBaseSpecifier& base : type.bases()) {
        const auto* record = base.getType()->getAsCXXRecordDecl();
        if (record != nullptr && record->hasDefinition()) eachOwn(*record->getDefinition(), visit);
    }
}
/// std::shared_ptr, boost::intrusive_ptr … and iterators: their value is the place that they point to.
bool isPointerLike(clang::QualType type);
bool isStdString(clang::QualType type);
/// std::vector, std::deque, std::list: elements in the order in which they were put there.
bool isSequence(clang::QualType type);
/// std::ostringstream, std::stringstream.
bool isTextStream(clang::QualType type);

/// Null if its body was not read.
const clang::FunctionDecl* definitionOf(const clang::FunctionDecl& function);

}  // namespace oroforge::cxx

#endif
