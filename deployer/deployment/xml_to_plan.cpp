// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "xml_to_plan.hpp"

#include "component_name.hpp"
#include "read_value.hpp"

#include <diag/nearest_match.hpp>
#include <xml/document.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <map>
#include <utility>

#include <unistd.h>

namespace fs = std::filesystem;

namespace OCL::deploy {
namespace {

/** True if the file exists; false also for an invalid path. */
bool isThere(const fs::path& path) {
    std::error_code error;
    return fs::exists(path, error);
}

/** A limit, because files that each include the next one twice would take for ever. */
constexpr std::size_t kMostIncludes = 1000;

/** Reads a file and, in the place of each Include, the included file. */
class PlanReader {
public:
    PlanReader(Plan& plan, diag::Sink& sink) : plan_(plan), sink_(sink) {}

    void readFile(const std::string& file) {
        open_.push_back(identity(file));
        if (const auto text = xml::readText(file, sink_)) readText(*text, file);
        open_.pop_back();
    }

    /** Reads statement by statement, so that only what the plan needs stays in memory. */
    void readText(const std::string& text, const std::string& name) {
        plan_.texts.push_back({name, text});
        const auto take = [this](const xml::Element& root, xml::Element&& child) {
            if (root.name == "properties" && child.name != "description") readTopLevel(std::move(child));
        };
        const auto document = xml::Document::parseText(text, name, sink_, xml::Blanks::condensed, take);
        if (!document) return;
        const xml::Element& root = document->root();
        if (root.name == "properties")
            checkText(root, sink_);
        else
            sink_.error(root.where, "DEP001", "found root element <" + root.name + ">, expected <properties>");
    }

private:
    static std::string identity(const std::string& file) {
        std::error_code error;
        const fs::path real = fs::canonical(file, error);
        return error ? file : real.string();
    }

    void readTopLevel(xml::Element&& element) {
        if (element.name == "simple") return readStatement(element);
        if (element.name != "struct") {
            sink_.error(element.where, "DEP002", "found <" + element.name + ">, expected <simple> or <struct>");
            return;
        }
        checkForm(element, sink_);
        const xml::Attribute* name = element.requireAttribute("name", sink_);
        if (!name) return;
        if (name->value.empty())
            sink_.error(name->valueWhere, "DEP003", "the name of a component or connection is empty");
        else if (isPolicy(element))
            readPolicyStruct(element);
        else if (name->value == "GlobalsRepository")
            readGlobals(element);
        else if (const std::string why = nameFault(name->value); !why.empty())
            sink_.error(name->valueWhere, "DEP063", "component '" + name->value + "' cannot have this name: " + why);
        else if (element.requireAttribute("type", sink_))
            plan_.components.push_back(readComponent(std::move(element), sink_));
    }

    /** The policy of this name is used for connections without one, and for members that others leave out. */
    void readPolicyStruct(const xml::Element& element) {
        PolicyPlan policy = readPolicy(element, plan_.defaultPolicy.value_or(RTT::ConnPolicy()), sink_);
        if (policy.name.value == "Default")
            plan_.defaultPolicy = policy.policy;
        else
            plan_.policies.push_back(std::move(policy));
    }

    void readStatement(const xml::Element& element) {
        const Text name = nameOf(element);
        static const std::vector<std::string> known = {"Import", "Path", "LoadLibrary", "Include"};
        const auto found = std::find(known.begin(), known.end(), name.value);
        if (found == known.end()) {
            sink_
                .error(name.where, "DEP002",
                       "unknown statement '" + name.value + "'" + diag::didYouMean(name.value, known))
                .hint("this level has the statements " + diag::oneOf(known) +
                      " and structs for components and connection policies");
            return;
        }
        checkForm(element, sink_);
        const auto text = readWord(element, sink_);
        if (!text) return;
        if (name.value == "Include")
            include(*text);
        else
            plan_.imports.push_back(ImportPlan{kindOf(name.value), *text});
    }

    static ImportPlan::Kind kindOf(const std::string& name) {
        return name == "Import" ? ImportPlan::Import : name == "Path" ? ImportPlan::Path : ImportPlan::LoadLibrary;
    }

    void include(const Text& file) {
        if (const std::string why = whyUnreadable(file, /*readOnce=*/true); !why.empty()) {
            sink_.error(file.where, "DEP020", why);
            return;
        }
        const std::string path = resolveFile(file);
        if (std::find(open_.begin(), open_.end(), identity(path)) != open_.end()) {
            sink_.error(file.where, "DEP007",
                        "'" + file.value + "' includes itself, directly or through the files it includes");
            return;
        }
        if (includes_ == kMostIncludes) {
            if (!std::exchange(tooMany_, true))
                sink_
                    .error(file.where, "DEP064",
                           "this is the include after the first " + std::to_string(kMostIncludes) +
                               ", which is as many as a deployment may have")
                    .hint("a file that is included several times counts each time, and so do those that it includes");
            return;
        }
        ++includes_;
        // A file has one name, so that places show what is read again. A link to it in another directory counts as
        // another file, because files that it names are looked up there.
        const fs::path directory = fs::path(path).parent_path();
        const std::string key =
            identity(directory.empty() ? "." : directory.string()) + '/' + fs::path(path).filename().string();
        readFile(names_.emplace(key, path).first->second);
    }

    void readGlobals(const xml::Element& element) {
        for (const xml::Element& child : element.children) {
            if (child.name == "description") continue;
            if (nameOf(child).value != "Properties")
                sink_.error(
                    child.where, "DEP006",
                    "unknown element '" + nameOf(child).value + "' in GlobalsRepository, expected 'Properties'");
            else if (readProperties(child, sink_))
                plan_.globals.push_back(child);
        }
    }

    Plan& plan_;
    diag::Sink& sink_;
    std::size_t includes_ = 0;
    bool tooMany_ = false;
    std::vector<std::string> open_;             // the current file and those that include it
    std::map<std::string, std::string> names_;  // the first name of each included file
};

/** Reports an empty plan, unless the file could not be read, which has been reported. */
void checkNotEmpty(const Plan& plan, diag::Sink& sink) {
    if (plan.imports.empty() && plan.policies.empty() && plan.components.empty() && plan.globals.empty() &&
        !plan.defaultPolicy && !sink.hadErrors())
        sink.error({plan.file, 0, 0}, "DEP008", "the file holds no statements");
}

}  // namespace

Plan readPlanFile(const std::string& file, diag::Sink& sink) {
    Plan plan;
    plan.file = file;
    PlanReader(plan, sink).readFile(file);
    checkNotEmpty(plan, sink);
    return plan;
}

Plan readPlanText(const std::string& text, const std::string& name, diag::Sink& sink) {
    Plan plan;
    plan.file = name;
    PlanReader(plan, sink).readText(text, name);
    checkNotEmpty(plan, sink);
    return plan;
}

std::string resolveFile(const Text& file) {
    const fs::path path = file.value;
    if (path.is_absolute() || isThere(path)) return file.value;
    const fs::path beside = fs::path(file.where.file.str()).parent_path() / path;
    if (!isThere(beside)) return file.value;
    // Shortens the path for messages, unless that changes it because the directory before ".." is a link.
    const fs::path plain = beside.lexically_normal();
    std::error_code ignored;
    return (fs::equivalent(plain, beside, ignored) ? plain : beside).string();
}

std::string whyUnreadable(const Text& file, bool readOnce) {
    const std::string path = resolveFile(file);
    std::error_code error;
    switch (fs::status(path, error).type()) {
        case fs::file_type::regular: break;
        case fs::file_type::fifo:
            if (readOnce) break;
            return "this is a pipe, expected a file: '" + file.value + "'";
        case fs::file_type::directory: return "this is a directory, expected a file: '" + file.value + "'";
        case fs::file_type::not_found: return "no such file: '" + file.value + "'";
        default:
            return error ? "the file '" + file.value + "' is out of reach: " + error.message()
                         : "this is no file that can be read: '" + file.value + "'";
    }
    if (access(path.c_str(), R_OK) == 0) return {};
    return "cannot read the file '" + file.value + "': " + std::strerror(errno);
}

}  // namespace OCL::deploy
