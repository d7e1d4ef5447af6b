// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Imports libraries and finds component types in them.
#ifndef OROFORGE_DEPLOYMENT_LIBRARIES_HPP
#define OROFORGE_DEPLOYMENT_LIBRARIES_HPP

#include <string>
#include <vector>

namespace OCL::deploy {

/** The type of what stands for a component of another process. */
bool isRemoteType(const std::string& type);
/** The component type: `word`, or the only type in the library file of that name, which is loaded. `error` gets the
    reason if the file cannot be loaded, or does not have exactly one type. */
std::string componentTypeOf(const std::string& word, std::string& error);
/** Why no component of that type can be created; empty if the loader has it. */
std::string unknownType(const std::string& type);

/** Imports a package, directory or library file. @throw std::runtime_error if a library in it cannot be loaded. */
bool importPackage(const std::string& package);
bool loadLibrary(const std::string& file, std::string& error);

/** The entries of a list, separated by colons or semicolons. */
std::vector<std::string> directoriesIn(const std::string& paths);
/** Those that are not directories. */
std::vector<std::string> missingDirectories(const std::string& paths);
/** Adds directories to the search path of components and plugins. */
void addSearchPath(const std::string& paths);
/** As addSearchPath(), and imports the libraries directly in them. */
void importPath(const std::string& paths);
/** Restores the search path in its destructor. */
class KeptSearchPath {
public:
    KeptSearchPath();
    ~KeptSearchPath();
    KeptSearchPath(const KeptSearchPath&) = delete;
    KeptSearchPath& operator=(const KeptSearchPath&) = delete;

private:
    const std::string components_, plugins_;
};

}  // namespace OCL::deploy

#endif
