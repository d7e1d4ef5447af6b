// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds the classes of the user in the sources of a package, and which bytes of the files are what.
#ifndef OROFORGE_GENERATOR_CLANG_UPDATE_USER_CLASS_HPP
#define OROFORGE_GENERATOR_CLANG_UPDATE_USER_CLASS_HPP

#include <map>
#include <string>
#include <vector>

#include <diag/sink.hpp>
#include <model/user_code.hpp>

namespace oroforge::cxx {

/// A class to look for, and signatures to be told how the compiler sees them in the class's namespace.
struct WantedClass {
    std::string name;  ///< qualified
    std::string base;  ///< qualified name of the class that the manifest generates
    std::vector<model::Signature> signatures;
};

struct UserCodeRequest {
    std::string root;                              ///< the package's folder, absolute
    std::string shown;                             ///< put before names of files in what is reported
    std::vector<std::string> sources;              ///< relative to root: these are read, and what they include
    std::vector<std::string> headers;              ///< read alone unless one of the sources includes them
    std::vector<std::string> flags;                ///< -I -isystem -D …
    std::map<std::string, std::string> generated;  ///< absolute path → text of headers that the build would make
    std::vector<WantedClass> classes;
};

/// `canonical[i][j]` belongs to signature j of class i. Text that makes no C++ is an error OC037, as its braces cannot be
/// trusted; includes that are not found are a warning. What is only wrong in its meaning is the build's to tell: after a
/// change of the manifest much is, until the classes are updated.
model::UserCode readUserCode(const UserCodeRequest& request,
                             std::vector<std::vector<model::CanonicalSignature>>& canonical, diag::Sink& sink);

}  // namespace oroforge::cxx

#endif
