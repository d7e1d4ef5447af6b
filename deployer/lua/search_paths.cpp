// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "search_paths.hpp"

#include <rtt/plugin/search_path.hpp>
#include <rtt/plugin/shared_library.hpp>

#include <string>
#include <sys/stat.h>

namespace OCL::lua {

namespace {

bool isFile(const std::string& path) {
    struct stat found;
    return stat(path.c_str(), &found) == 0 && S_ISREG(found.st_mode);
}

/** The folder of the modules, which is a fixed number of levels above this library; empty if there is none. */
std::string modules() {
    // The linker names it by the way on which it was found, such as `ocl/plugins/../`.
    std::string folder = RTT::plugin::canonicalPath(
        RTT::plugin::SharedLibrary::fileWith(reinterpret_cast<const void*>(&setSearchPaths)));
    for (int levels = 0; levels != 6; ++levels) {
        const std::string::size_type slash = folder.find_last_of('/');
        if (slash == std::string::npos) break;
        folder.erase(slash);
        const std::string found = folder + "/share/lua/5.1";
        if (isFile(found + "/rttlib.lua")) return found;
    }
    return "";
}

}  // namespace

void setSearchPaths(lua_State* lua) {
    const std::string folder = modules();
    if (folder.empty()) return;
    lua_getglobal(lua, "package");
    lua_getfield(lua, -1, "path");
    const std::string pattern = folder + "/?.lua";
    const std::string before = lua_isstring(lua, -1) ? lua_tostring(lua, -1) : "";
    lua_pop(lua, 1);
    if ((";" + before + ";").find(";" + pattern + ";") == std::string::npos) {
        lua_pushstring(lua, (before + (before.empty() ? "" : ";") + pattern).c_str());
        lua_setfield(lua, -2, "path");
    }
    lua_pop(lua, 1);
}

}  // namespace OCL::lua
