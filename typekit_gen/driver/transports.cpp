// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "transports.hpp"

#include <algorithm>

#include <diag/nearest_match.hpp>

namespace oroforge::typekit {

namespace {

bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool isKnown(const std::string& name, diag::Sink& sink) {
    if (has(knownTransports(), name)) return true;
    sink.error({"typegen"}, "TK003",
               "unknown transport '" + name + "', expected " + diag::oneOf(knownTransports()) +
                   diag::didYouMean(name, knownTransports()));
    return false;
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text.empty() ? "none" : text;
}

}  // namespace

const std::vector<std::string>& knownTransports() {
    static const std::vector<std::string> names = {"corba", "mqueue", "ros", "typelib"};
    return names;
}

const std::vector<std::string>& installedTransports() {
    static const std::vector<std::string> names = {"corba", "mqueue"};
    return names;
}

std::vector<std::string> chooseTransports(const std::vector<std::string>& wanted,
                                          const std::vector<std::string>& unwanted, diag::Sink& sink) {
    for (const std::string& name : unwanted) isKnown(name, sink);
    std::vector<std::string> chosen;
    for (const std::string& name : wanted) {
        if (has(chosen, name) || !isKnown(name, sink) || has(unwanted, name)) continue;
        chosen.push_back(name);
        if (has(installedTransports(), name)) continue;
        sink.error({"typegen"}, "TK068",
                   "transport '" + name + "' is not part of this toolchain's installation; installed: " +
                       listed(installedTransports()) + ", known: " + listed(knownTransports()))
            .hint("leave '" + name + "' out of -t");
    }
    return chosen;
}

}  // namespace oroforge::typekit
