// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "categories.hpp"

#ifdef OROFORGE_WITH_LOG4CPP
#include <ocl/Category.hpp>

#include <log4cpp/PropertyConfigurator.hh>
#endif

#include <cerrno>
#include <cstring>
#include <exception>
#include <fstream>

#include <sys/stat.h>

namespace OCL::deploy {

#ifdef OROFORGE_WITH_LOG4CPP
std::string prepareCategories(const std::string& file, bool checkOnly) {
    // A failure is in the log, and components that need the categories fail.
    (void)OCL::logging::Category::installFactory();
    if (file.empty()) return {};
    const std::string where = "log4cpp cannot be configured: ";
    // log4cpp opens it again, and reads a device without an end for ever.
    struct stat found {};
    if (::stat(file.c_str(), &found) == 0 && !S_ISREG(found.st_mode) && !S_ISDIR(found.st_mode))
        return where + "it is not a regular file";
    std::ifstream in(file);
    if (!in || (in.peek(), in.bad())) return where + std::strerror(errno);
    if (checkOnly) return {};
    try {
        log4cpp::PropertyConfigurator::configure(file);
        return {};
    } catch (const std::exception& thrown) {
        return where + thrown.what();
    }
}
#else
std::string prepareCategories(const std::string& file, bool) {
    return file.empty() ? std::string()
                        : "there is no log4cpp to be configured; this program was built without it (liblog4cpp5-dev)";
}
#endif

}  // namespace OCL::deploy
