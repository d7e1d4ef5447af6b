// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_MCAP_FILE_PACKAGES_HPP
#define OROFORGE_MCAP_FILE_PACKAGES_HPP

#include <string>

#include <sys/types.h>

namespace OCL::recording {

/** The packages whose components, typekits and plugins a process of this computer has loaded, with the versions that
    their pkg-config files name: "ocl 1.2.0, tank 1.0". Empty if the process may not be looked at. Reads files. */
std::string packagesOf(pid_t process);

}  // namespace OCL::recording

#endif
