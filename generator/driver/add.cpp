// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <driver/add.hpp>

#include <filesystem>
#include <optional>
#include <ostream>
#include <regex>

#include <nlohmann/json.hpp>

#include <check/check.hpp>
#include <driver/kinds.hpp>
#include <driver/package_files.hpp>
#include <merge/text_places.hpp>
#include <view/cpp_text.hpp>
#include <view/skeleton_view.hpp>
#include <view/view.hpp>

namespace fs = std::filesystem;

namespace oroforge::driver {

namespace {

const diag::Location kHere{"orocreate-pkg", 0, 0};
const char* const kBuildFile = "CMakeLists.txt";

/// The text with each comment and quoted text blanked out, so that what is found in it is a command.
std::string withoutComments(const std::string& cmake) {
    std::string text = cmake;
    char inside = 0;  // '#' in a comment, '"' in a quoted text
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = cmake[i];
        if (inside == 0 && (c == '#' || c == '"')) {
            inside = c;
        } else if ((inside == '#' && c == '\n') || (inside == '"' && c == '"' && cmake[i - 1] != '\\')) {
            inside = 0;
        }
        if (inside == '#') text[i] = ' ';
    }
    return text;
}

struct Command {
    std::size_t begin = 0;  ///< of its line
    std::size_t close = 0;  ///< of its closing parenthesis
    std::string first;      ///< its first argument
};

std::optional<Command> findCommand(const std::string& cmake, const std::string& name) {
    const std::string text = withoutComments(cmake);
    const std::regex pattern("(^|\\n)([ \\t]*)" + name + "[ \\t]*\\([ \\t\\r\\n]*([^ \\t\\r\\n)]*)", std::regex::icase);
    std::smatch match;
    if (!std::regex_search(text, match, pattern)) return std::nullopt;
    Command command;
    command.begin = static_cast<std::size_t>(match.position(2));
    command.close = text.find(')', static_cast<std::size_t>(match.position(3)));
    command.first = match[3];
    if (command.close == std::string::npos) return std::nullopt;
    return command;
}

/// Headers stand before the first of the words that have a meaning of their own, as DEPENDS.
std::size_t endOfHeaders(const std::string& cmake, const Command& call) {
    const std::string arguments = withoutComments(cmake).substr(call.begin, call.close - call.begin);
    std::smatch keyword;
    if (!std::regex_search(arguments, keyword, std::regex("[ \\t\\r\\n]+[A-Z_]+(?=[ \\t\\r\\n]|$)"))) return call.close;
    return call.begin + static_cast<std::size_t>(keyword.position());
}

/// What is written: files that must not be there yet, and the build file.
struct Additions {
    emit::Outputs files;
    std::string targets;  ///< for CMakeLists.txt
    std::string header;   ///< to be listed by orocos_typegen_headers()
};

std::string withTargets(const std::string& cmake, const Additions& additions, diag::Sink& sink) {
    std::string text = cmake;
    std::string targets = additions.targets;
    if (!additions.header.empty()) {
        if (const auto call = findCommand(text, "orocos_typegen_headers")) {
            text.insert(endOfHeaders(text, *call), " " + additions.header);
        } else {
            targets = "\norocos_typegen_headers(" + additions.header + ")\n";
        }
        targets += "\norocos_install_headers(" + additions.header + ")\n";
    }
    const auto last = findCommand(text, "orocos_generate_package");
    if (!last) {
        sink.error({kBuildFile, 0, 0}, "OC011",
                   "there is no orocos_generate_package() before which the target could go")
            .hint("these lines are to be added by hand:" + targets);
        return cmake;
    }
    // What it makes begins with an empty line; the one in front of the command goes behind it.
    std::string block = targets.substr(targets.find_first_not_of('\n')) + "\n";
    block = std::regex_replace(block, std::regex("\n"), merge::lineEndOf(text));
    text.insert(last->begin, block);
    return text;
}

Additions additionsFor(const std::string& package, const Options& options, const render::Renderer& renderer) {
    const std::string& kind = options.add[0];
    const std::string& name = options.add[1];
    model::Package part;
    part.name = {package, {kHere.file, 1, 1}};
    Additions additions;
    if (kind == "typekit") {
        additions.header = typekitHeader(package, name);
        nlohmann::json view = view::typekitView(part, additions.header);
        view["class"] = view::className(name);
        additions.files[additions.header] = renderer.render("package/types.hpp", view);
        return additions;
    }
    part.skeletons.push_back(*skeletonOf(kind, name, options));
    additions.files = skeletonFiles(part, renderer);
    if (part.skeletons.front().kind == model::SkeletonKind::Component && !fs::exists("tests/test_main.cpp")) {
        additions.files["tests/test_main.cpp"] = renderer.render("package/test_main.cpp", nlohmann::json::object());
    }
    additions.targets = renderer.render("package/targets", view::skeletonsView(part));
    return additions;
}

}  // namespace

void addPart(const Options& options, const render::Renderer& renderer, std::ostream& out, diag::Sink& sink) {
    static const std::vector<std::string> known = {"component", "service", "plugin",
                                                   "support",   "typekit", "application"};
    checkKind(options.add[0], known, sink);
    const std::string fault = check::packageNameFault(options.add[1]);
    if (!fault.empty()) sink.error(kHere, "OC002", "name '" + options.add[1] + "' " + fault);
    checkNames(options, sink);
    const std::string cmake = emit::textOf(kBuildFile);
    const auto project = findCommand(cmake, "project");
    if (!project) {
        sink.error(kHere, "OC009",
                   "no package here: expected a CMakeLists.txt with project() in the current directory");
    }
    if (project && !check::packageNameFault(project->first).empty()) {
        sink.error({kBuildFile, 0, 0}, "OC009",
                   "the package is named '" + project->first + "' by project(); expected a plain name there");
    }
    if (sink.hadErrors()) return;

    Additions additions = additionsFor(project->first, options, renderer);
    for (const auto& [file, text] : additions.files) {
        if (fs::exists(file)) sink.error({file, 0, 0}, "OC010", "the file is there already; nothing was written");
    }
    additions.files[kBuildFile] = withTargets(cmake, additions, sink);
    if (!sink.hadErrors()) writeOutputs(additions.files, ".", options.dryRun, out, sink);
}

}  // namespace oroforge::driver
