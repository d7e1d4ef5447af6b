// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What typegen reads besides C++: comments, adapter files, compile databases, options. The same bytes go to each reader.
#include "fuzzing.hpp"

#include <adapters/read_adapters.hpp>
#include <clang/types/doc_comment.hpp>
#include <diag/sink.hpp>
#include <driver/options.hpp>
#include <flags/command_words.hpp>
#include <flags/compile_database.hpp>
#include <flags/flags_file.hpp>

#include "typegen/scratch_folder.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace oroforge;
using fuzz::ScratchFolder;

namespace {

void requireFlags(const std::vector<std::string>& flags) {
    static const std::set<std::string> valued = {"-isystem", "-include", "-I", "-D", "-U"};
    for (std::size_t i = 0; i < flags.size(); ++i) {
        const std::string& flag = flags[i];
        if (flag.compare(0, 5, "-std=") == 0) continue;
        require(valued.count(flag) != 0 && ++i < flags.size() && !flags[i].empty(), "flags have values", flag);
    }
}

void checkErrors(const diag::Sink& sink, const std::string& file) {
    for (const diag::Diagnostic& one : sink.all())
        require(!one.message.empty() && one.where.file.str() == file, "errors say something, and where", one.message);
}

void checkComment(const std::string& text) {
    const cxx::DocComment doc = cxx::parseDocText(text);
    for (const std::string* value : {&doc.unit, &doc.range, &doc.capacity, &doc.make})
        require(value->find('\n') == std::string::npos, "what follows a word of ours ends with the line", *value);
    for (const std::string& line : {doc.text, doc.unit, doc.range, doc.capacity, doc.make})
        require(line.empty() || (line.front() != ' ' && line.back() != ' '), "nothing has blanks around it", line);
}

void checkAdapters(const std::string& text, const ScratchFolder& folder) {
    const std::string file = folder.write("adapters.xml", text);
    diag::Sink sink;
    const auto found = adapters::readAdapters({file}, sink);
    checkErrors(sink, file);
    for (const diag::Diagnostic& one : sink.all()) require(one.where.line != 0, "errors have places", one.message);
    if (sink.hadErrors()) return;
    for (const adapters::Adapter& adapter : found) {
        require(!adapter.className.empty(), "adapters are for a class");
        for (const adapters::Member& member : adapter.members) {
            require(member.get.given() && !member.get.steps.empty(), "members are reached", member.name);
            diag::Sink again;
            const std::string cpp = cppOf(member.get);
            const auto same = adapters::parseAccessor(cpp, {}, {}, again);
            require(again.empty() && cppOf(same) == cpp, "accessors are C++ of the same form", cpp);
        }
    }
}

void checkDatabase(const std::string& text, const ScratchFolder& folder) {
    const std::string file = folder.write("compile_commands.json", text);
    for (const std::string& wanted : {std::string(), std::string("a.cpp")}) {
        diag::Sink sink;
        const auto flags = flags::readCompileDatabase(file, wanted, {"/somewhere/include/a.hpp"}, sink);
        require(flags.has_value() != sink.hadErrors(), "there are flags or an error");
        checkErrors(sink, file);
        if (!flags) continue;
        requireFlags(flags->flags);
        requireFlags(flags::withoutOverridden(flags->flags, {"-D", "A=1", "-std=c++20"}));
    }
}

void checkOptions(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    diag::Sink sink;
    const auto options = typekit::parseOptions(lines, sink);
    require(options.has_value() != sink.hadErrors(), "there are options or an error");
    if (options) requireFlags(options->flags);
    requireFlags(flags::meaningfulFlags(lines));
    requireFlags(flags::flagsOfCommand(flags::splitCommand(text), "/somewhere"));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const ScratchFolder folder;
    const std::string text(reinterpret_cast<const char*>(data), size);
    checkComment(text);
    checkAdapters(text, folder);
    checkDatabase(text, folder);
    checkOptions(text);
    return 0;
}
