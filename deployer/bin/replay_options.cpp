// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "option_values.hpp"

#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

namespace OCL::deploy {

namespace po = boost::program_options;

namespace {

void takeNames(const std::string& value, std::vector<std::string>& names, std::string& error) {
    std::istringstream words(value);
    for (std::string word; std::getline(words, word, ',');)
        if (!word.empty()) names.push_back(word);
    if (names.empty()) error = "--replace names no component";
}

}  // namespace

void takeReplay(const po::variables_map& values, Options& options, std::string& error) {
    if (values.count("replay")) options.replayFile = values["replay"].as<std::string>();
    if (values.count("record")) options.recordFile = values["record"].as<std::string>();
    if (values.count("replace")) takeNames(values["replace"].as<std::string>(), options.replaced, error);
    options.tolerate = values.count("tolerate") != 0;
    options.replayCheck = values.count("replay-check") != 0;
    for (const char* name : {"replace", "record", "replay-speed", "tolerate", "replay-check"})
        if (values.count(name) && !values.count("replay"))
            error = std::string("--") + name + " is of no use without --replay";
    for (const char* name : {"replay", "record"})
        if (values.count(name) && values[name].as<std::string>().empty())
            error = std::string("the name of the file of --") + name + " is empty";
    if (!options.replayFile.empty() && options.endsAtOnce())
        error = "--replay executes components, which --check and --dry-run do not start";
    if (!options.replayFile.empty() && options.realTimeCheck)
        error = "--rt-check watches threads with a real-time scheduler, which a replay does not have";
    if (!values.count("replay-speed")) return;
    const std::string speed = values["replay-speed"].as<std::string>();
    char* end = nullptr;
    options.replaySpeed = std::strtod(speed.c_str(), &end);
    if (speed.empty() || *end != '\0' || !(options.replaySpeed >= 1e-6 && options.replaySpeed <= 1e6))
        error = "no speed: '" + speed + "'; expected a number from 0.000001 to 1000000";
}

}  // namespace OCL::deploy
