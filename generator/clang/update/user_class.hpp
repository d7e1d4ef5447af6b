// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds the user's classes in the sources of a package, and the bytes of their parts.
#ifndef OROFORGE_GENERATOR_CLANG_UPDATE_USER_CLASS_HPP
#define OROFORGE_GENERATOR_CLANG_UPDATE_USER_CLASS_HPP

#include <map>
#include <string>
#include <vector>

#include <diag/sink.hpp>
#include <model/user_code.hpp>

namespace oroforge::cxx {

/// A class to look for, and signatures to resolve in the class's namespace.
struct WantedClass {
    std::string name;  ///< qualified
    std::string base;  ///< qualified name of the class that the manifest generates
    std::vector<model::Signature> signatures;
};

struct UserCodeRequest {
    std::string root;                              ///< the package's folder, absolute
    std::string shown;                             ///< goes before file names in messages
    std::vector<std::string> sources;              ///< relative to root; these are read with their includes
    std::vector<std::string> headers;              ///< read alone unless one of the sources includes them
    std::vector<std::string> flags;                ///< -I -isystem -D …
    std::map<std::string, std::string> generated;  ///< absolute path → text of headers that the build would make
    std::vector<WantedClass> classes;
};

/// `canonical[i][j]` belongs to signature j of class i. Text that is not C++ is an error OC037, because its braces
/// cannot be trusted; missing includes are a warning. Errors of meaning are left to the build: after a change of the
/// manifest there are many until the classes are updated.
model::UserCode readUserCode(const UserCodeRequest& request,
                             std::vector<std::vector<model::CanonicalSignature>>& canonical, diag::Sink& sink);

}  // namespace oroforge::cxx

#endif
