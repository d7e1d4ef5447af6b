// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "commands.hpp"
#include "new_file.hpp"

#include <reporting/mcap/salvage.hpp>
#include <reporting/mcap/source.hpp>
#include <reporting/mcap/summary.hpp>

#include <cstdio>
#include <iostream>

namespace oroforge::mcap {
namespace {

std::string recoveredName(const std::string& file) {
    const std::string end = ".mcap";
    const bool hasEnd = file.size() > end.size() && file.compare(file.size() - end.size(), end.size(), end) == 0;
    return file.substr(0, file.size() - (hasEnd ? end.size() : 0)) + "_recovered" + end;
}

}  // namespace

int recover(const ToolOptions& options) {
    const std::string& file = options.files[0];
    const std::string name = options.output.empty() ? recoveredName(file) : options.output;
    std::string why;
    const std::unique_ptr<Source> source = openSource(file, why);
    if (!source) {
        std::cerr << file << ": error: " << why << "\n";
        return kFailed;
    }
    std::unique_ptr<NewFile> output = NewFile::make(name);
    if (!output) return kFailed;
    Salvaged result = salvage(*source, *output);
    Summary summary;
    if (result.problems.empty())
        if (const Problem index = readSummary(*source, summary)) result.problems.push_back(index);
    for (const Problem& problem : result.problems) std::cerr << problem.line(file) << "\n";
    output.reset();
    const bool isOther = result.chunks == 0 && !result.problems.empty();  // no recording, or nothing of one
    if (!result.error.empty()) std::cerr << name << ": error: " << result.error << "\n";
    if (isOther) std::cerr << file << ": error: nothing of it can be recovered\n";
    if (isOther || !result.error.empty()) {
        (void)std::remove(name.c_str());
        return kFailed;
    }
    std::cout << name << " has " << result.messages << " messages in " << result.chunks << " chunks\n";
    return result.problems.empty() ? kGood : kDamaged;
}

}  // namespace oroforge::mcap
