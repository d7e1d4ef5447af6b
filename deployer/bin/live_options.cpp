// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "option_values.hpp"

#include <diag/nearest_match.hpp>

#include <sstream>
#include <vector>

namespace OCL::deploy {

namespace po = boost::program_options;
namespace diag = oroforge::diag;

namespace {

const std::vector<std::string> kPermissions = {"properties", "operations", "lifecycle"};

/** Takes "https://view.example,http://10.0.0.5:8080", as browsers write them in the header Origin. */
void takeOrigins(const std::string& value, Options& options, std::string& error) {
    std::istringstream words(value);
    for (std::string word; std::getline(words, word, ',');) {
        const std::size_t host = word.find("://");
        const std::string scheme = word.substr(0, host);
        const bool good = (scheme == "http" || scheme == "https") && host + 3 < word.size() &&
                          word.find_first_of("/*?# ", host + 3) == std::string::npos;
        if (good)
            options.webOrigins.push_back(word);
        else
            error = "'" + word +
                    "' of --web-origin is no site; write http:// or https:// and the host, as "
                    "https://view.example:8443, without a path";
    }
}

}  // namespace

void takeLive(const po::variables_map& values, Options& options, std::string& error) {
    options.live = !values.count("no-live");
    if (values.count("web")) options.webAddress = values["web"].as<std::string>();
    if (values.count("web") && options.webAddress.empty()) error = "the address of --web is empty";
    if (values.count("web-token-file")) options.webTokenFile = values["web-token-file"].as<std::string>();
    for (const char* name : {"web-allow", "web-origin", "web-token-file"})
        if (values.count(name) && !values.count("web"))
            error = std::string("--") + name + " is of no use without --web";
    if (values.count("web-origin")) takeOrigins(values["web-origin"].as<std::string>(), options, error);
    if (!values.count("web-allow")) return;
    std::istringstream words(values["web-allow"].as<std::string>());
    for (std::string word; std::getline(words, word, ',');) {
        if (word == kPermissions[0])
            options.webMay.properties = true;
        else if (word == kPermissions[1])
            options.webMay.operations = true;
        else if (word == kPermissions[2])
            options.webMay.lifecycle = true;
        else
            error = "unknown permission '" + word + "' of --web-allow, expected " + diag::oneOf(kPermissions) +
                    diag::didYouMean(word, kPermissions);
    }
}

}  // namespace OCL::deploy
