// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A console for two components, without a terminal.
#ifndef OROFORGE_CONSOLE_FIXTURE_HPP
#define OROFORGE_CONSOLE_FIXTURE_HPP

#include <console/console.hpp>
#include <rtt/Component.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/deployment/ComponentLoader.hpp>
#include <rtt/plugin/PluginLoader.hpp>
#include <support/temp_dir.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <sstream>
#include <string>

struct Unload {
    void operator()(RTT::TaskContext* component) const { RTT::ComponentLoader::Instance()->unloadComponent(component); }
};
typedef std::unique_ptr<RTT::TaskContext, Unload> Loaded;

inline Loaded loadTank(const char* name, const char* type) {
    return Loaded(RTT::ComponentLoader::Instance()->loadComponent(name, type));
}

/** A component "plant" with the peers "tank" and "pump" of the example. */
class ConsoleTest : public testing::Test {
protected:
    ConsoleTest() : plant("plant"), browser("TaskBrowser") {
        for (const char* const file : {RTT_TYPEKIT_FILE, RTT_SCRIPTING_FILE})
            RTT::plugin::PluginLoader::Instance()->loadLibrary(file);
        RTT::ComponentLoader::Instance()->loadLibrary(CONSOLE_FILLING_FILE);
        tank = loadTank("tank", "filling::Tank");
        pump = loadTank("pump", "filling::Pump");
        plant.addPeer(tank.get());
        plant.addPeer(pump.get());
        console = std::make_unique<OCL::console::Console>(browser, plant, out, err, "typed");
    }
    ~ConsoleTest() override { console.reset(); }

    /** What the lines write to standard output. */
    std::string answer(const std::string& lines) {
        out.str("");
        err.str("");
        std::istringstream in(lines);
        for (std::string line; std::getline(in, line);) console->execute(line);
        return out.str();
    }
    /** What they write to standard error. */
    std::string complaint(const std::string& lines) {
        answer(lines);
        return err.str();
    }

    RTT::TaskContext plant, browser;
    Loaded tank, pump;
    std::ostringstream out, err;
    std::unique_ptr<OCL::console::Console> console;
};

#endif
