// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <driver/kinds.hpp>

#include <algorithm>
#include <filesystem>
#include <ostream>

#include <check/check.hpp>
#include <diag/nearest_match.hpp>
#include <emit/outputs.hpp>
#include <model/cpp_type.hpp>
#include <view/cpp_text.hpp>
#include <xml/escape.hpp>

namespace fs = std::filesystem;

namespace oroforge::driver {

namespace {

using model::SkeletonKind;

const diag::Location kHere{"orocreate-pkg", 0, 0};

struct Kind {
    const char* word;
    const char* makes;
    std::optional<SkeletonKind> skeleton;
    const char* source;  ///< a file that shows that a package has this kind; it contains "NAME"
    bool inAll;
};

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all = {
        {"component", "a component with its test and deployment", SkeletonKind::Component, "src/NAME-component.cpp",
         true},
        {"service", "a service that components load by name", SkeletonKind::Service, "src/NAME-service.cpp", true},
        {"plugin", "code that is loaded into the process or a component", SkeletonKind::Plugin, "src/NAME-plugin.cpp",
         true},
        {"support", "a library that components share", SkeletonKind::Support, "src/NAME-support.cpp", true},
        {"typekit", "a header of types, and the typekit that typegen makes of it", std::nullopt,
         "include/NAME/NAME-types.hpp", true},
        {"application", "a program that runs components without a deployer", SkeletonKind::Application,
         "src/NAME-application.cpp", false},
        {"topics", "a component whose ports are topics of ROS, with its launch file", SkeletonKind::Topics,
         "src/NAME-topics.cpp", false},
        {"all", "component, service, plugin, support and typekit; the same as no kind", std::nullopt, "", false},
        {"cmake", "the build files alone", std::nullopt, "", false},
        {"empty", "package.xml alone", std::nullopt, "", false},
    };
    return all;
}

std::vector<std::string> kindWords() {
    std::vector<std::string> words;
    for (const Kind& kind : kinds()) words.push_back(kind.word);
    return words;
}

std::string withName(std::string pattern, const std::string& name) {
    for (std::size_t at = 0; (at = pattern.find("NAME", at)) != std::string::npos; at += name.size()) {
        pattern.replace(at, 4, name);
    }
    return pattern;
}

std::string classOf(SkeletonKind kind, const std::string& name, const Options& options) {
    std::string last = options.className.empty() ? view::className(name) : options.className;
    if (kind == SkeletonKind::Service) last += "Service";
    if (kind == SkeletonKind::Topics) last += "Topics";
    if (kind == SkeletonKind::Application) last += "Application";
    return options.nameSpace.empty() ? last : options.nameSpace + "::" + last;
}

bool areIdentifiers(const std::string& qualified) {
    const auto parts = model::splitQualified(qualified);
    return !parts.empty() && std::all_of(parts.begin(), parts.end(), [](const std::string& part) {
        return model::isIdentifier(part) && !model::isKeyword(part);
    });
}

/// Parses "Ann Other <ann@example.org>", or the name alone.
model::Person personOf(const std::string& author, diag::Sink& sink) {
    const diag::Location given{kHere.file, 1, 1};
    const auto open = author.find('<');
    std::string name = author.substr(0, open);
    name.erase(name.find_last_not_of(" \t") + 1);
    std::string email;
    if (open != std::string::npos) {
        const auto close = author.find('>', open);
        email = author.substr(open + 1, close == std::string::npos ? close : close - open - 1);
    }
    const bool mail = email.empty() ? open == std::string::npos : email.find('@') != std::string::npos;
    if (name.empty() || !mail) {
        sink.error(kHere, "OC008", "author '" + author + "' has no name or a malformed address")
            .hint("expected \"Ann Other <ann@example.org>\" or \"Ann Other\"");
    }
    return {{name, given}, {email, email.empty() ? diag::Location{} : given}};
}

}  // namespace

std::string typekitHeader(const std::string& package, const std::string& name) {
    return "include/" + package + "/" + name + "-types.hpp";
}

bool checkKind(const std::string& kind, const std::vector<std::string>& known, diag::Sink& sink) {
    if (std::find(known.begin(), known.end(), kind) != known.end()) return true;
    sink.error(kHere, "OC003",
               "unknown kind '" + kind + "', expected " + diag::oneOf(known) + diag::didYouMean(kind, known));
    return false;
}

void checkNames(const Options& options, diag::Sink& sink) {
    if (!options.className.empty() &&
        (!areIdentifiers(options.className) || options.className.find(':') != std::string::npos)) {
        sink.error(kHere, "OC008",
                   "class '" + options.className + "' is not an identifier; its namespace is --namespace");
    }
    if (!options.nameSpace.empty() && !areIdentifiers(options.nameSpace)) {
        sink.error(kHere, "OC008",
                   "namespace '" + options.nameSpace + "' is not a namespace: expected identifiers joined by '::'");
    }
}

std::optional<model::Skeleton> skeletonOf(const std::string& kind, const std::string& name, const Options& options) {
    for (const Kind& known : kinds()) {
        if (known.word == kind && known.skeleton) {
            return model::Skeleton{*known.skeleton, name, classOf(*known.skeleton, name, options)};
        }
    }
    return std::nullopt;
}

model::Package packageOfKinds(const Options& options, diag::Sink& sink) {
    const diag::Location given{kHere.file, 1, 1};
    const std::string& name = options.words.front();
    const std::vector<std::string> wanted(options.words.begin() + 1, options.words.end());
    const std::string fault = check::packageNameFault(name);
    if (!fault.empty()) sink.error(kHere, "OC002", "package name '" + name + "' " + fault);
    for (const std::string& kind : wanted) checkKind(kind, kindWords(), sink);
    checkNames(options, sink);

    const auto asks = [&](const char* word) { return std::find(wanted.begin(), wanted.end(), word) != wanted.end(); };
    const bool all = wanted.empty() || asks("all");
    model::Package package;
    package.name = {name, given};
    for (const Kind& kind : kinds()) {
        if (*kind.source == '\0') continue;
        const bool has = fault.empty() && emit::exists(fs::path(name) / withName(kind.source, name));
        if (!(all && kind.inAll) && !asks(kind.word) && !has) continue;
        if (const auto skeleton = skeletonOf(kind.word, name, options)) {
            package.skeletons.push_back(*skeleton);
        } else {
            package.typekitHeaders.push_back({typekitHeader(name, name), given});
        }
    }
    if (!options.license.empty()) package.license = {xml::asUtf8(options.license), given};
    for (const std::string& author : options.authors) package.authors.push_back(personOf(xml::asUtf8(author), sink));
    for (const model::Person& person : package.authors) {
        if (person.email.given()) package.maintainers.push_back(person);
    }
    return package;
}

void listKinds(const render::Templates& templates, std::ostream& out) {
    out << "kinds:\n";
    for (const Kind& kind : kinds()) {
        const std::string word = kind.word;
        out << "  " << word << std::string(word.size() < 14 ? 14 - word.size() : 1, ' ') << kind.makes << '\n';
    }
    out << "templates that --template-dir DIR can replace, by DIR/NAME.mustache:\n";
    for (const std::string& name : templates.names()) out << "  " << name << '\n';
}

}  // namespace oroforge::driver
