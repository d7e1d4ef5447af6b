// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "typegen_ros.hpp"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <ostream>

#include <diag/print.hpp>
#include <emit/depfile.hpp>
#include <emit/outputs.hpp>
#include <explain/explanations.hpp>
#include <messages/identity.hpp>
#include <messages/message_files.hpp>
#include <messages/parse_message.hpp>
#include <render/renderer.hpp>
#include <report/report.hpp>

#include "ros_options.hpp"

namespace fs = std::filesystem;

namespace oroforge::embedded {
diag::EmbeddedFiles messageTemplates();
}

namespace oroforge::messages {

namespace {

constexpr const char* kName = "typegen-ros";

const char* const kKinds[] = {"msg", "srv"};

class Run {
public:
    Run(const RosOptions& options, diag::Sink& sink, std::ostream& out)
        : options_(options), sink_(sink), out_(out), set_(search_, sink) {
        for (const auto& [package, folder] : options.paths) search_.add(package, folder);
        rules_.includes = options.includes;
        if (options.perSource != 0) rules_.perSource = options.perSource;
    }

    void run() {
        switch (options_.command) {
            case Command::Messages: return generate("msg");
            case Command::Services: return generate("srv");
            case Command::Md5:
            case Command::Definition: return identify();
            case Command::Dependencies: return dependencies();
            default: return;
        }
    }

private:
    std::vector<std::string> filesOf(const std::string& package, const std::string& kind) {
        std::vector<std::string> files, names;
        std::error_code error;
        for (const std::string& folder : search_.foldersOf(package, kind))
            for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
                const std::string name = entry.path().stem().string();
                if (entry.path().extension() != "." + kind || std::count(names.begin(), names.end(), name)) continue;
                names.push_back(name);
                files.push_back(entry.path().string());
            }
        std::sort(files.begin(), files.end());
        return files;
    }

    bool isKnown(const std::string& package) {
        for (const char* kind : kKinds)
            if (!search_.foldersOf(package, kind).empty()) return true;
        if (!search_.folderOf(package).empty()) return true;
        sink_.error({kName}, "RM006", "no package '" + package + "'; searched: " + search_.described());
        return false;
    }

    void generate(const std::string& kind) {
        const std::string package = options_.words[0];
        std::vector<std::string> files(options_.words.begin() + 1, options_.words.end());
        if (files.empty() && !isKnown(package)) return;
        if (files.empty()) files = filesOf(package, kind);
        if (files.empty()) {
            sink_.error({kName}, "RM006", "package '" + package + "' has no ." + kind + " files");
            return;
        }
        std::vector<std::string> names;
        for (const std::string& file : files) names.push_back(fs::path(file).stem().string());
        rules_.isForUsers = kind == "msg";
        if (options_.listOutputs) {
            const auto outputs =
                kind == "msg" ? messageOutputs(package, names, rules_) : serviceOutputs(package, names, rules_);
            emit::listOutputs(out_, outputs, options_.output);
            return;
        }
        const emit::Outputs outputs = kind == "msg" ? ofMessages(package, files, names) : ofServices(package, files);
        if (sink_.hadErrors() || !emit::writeGenerated(outputs, options_.output, sink_)) return;
        if (!options_.depfile.empty()) writeDependencies(outputs);
    }

    emit::Outputs ofMessages(const std::string& package, const std::vector<std::string>& files,
                             const std::vector<std::string>& names) {
        for (const std::string& file : files) set_.addFile(package, file);
        std::vector<const Message*> messages;
        for (const std::string& name : names) messages.push_back(set_.message(package + "/" + name, {kName}));
        if (sink_.hadErrors()) return {};
        return renderMessages(package, messages, set_, rules_, renderer());
    }

    emit::Outputs ofServices(const std::string& package, const std::vector<std::string>& files) {
        std::vector<const Service*> services;
        for (const std::string& file : files) services.push_back(set_.service(package, file));
        if (sink_.hadErrors()) return {};
        return renderServices(package, services, set_, rules_, renderer());
    }

    static render::Renderer renderer() { return render::Renderer(render::Templates(embedded::messageTemplates())); }

    void writeDependencies(const emit::Outputs& outputs) {
        const fs::path folder = fs::absolute(options_.output).lexically_normal();
        std::vector<std::string> targets;
        if (!options_.depfileTarget.empty()) targets = {options_.depfileTarget};
        if (options_.depfileTarget.empty())
            for (const auto& [name, text] : outputs) targets.push_back((folder / name).string());
        std::vector<std::string> inputs;
        for (const std::string& file : set_.files()) inputs.push_back(fs::absolute(file).lexically_normal().string());
        emit::writeDepfile(options_.depfile, targets, inputs, sink_);
    }

    void identify() {
        for (const std::string& name : options_.words) {
            const std::size_t slash = name.find('/');
            if (slash == std::string::npos) {
                sink_.error({kName}, "RM008", "'" + name + "' is not PACKAGE/NAME");
                continue;
            }
            const std::string package = name.substr(0, slash);
            std::string service;
            for (const std::string& folder : search_.foldersOf(package, "srv")) {
                const std::string file = folder + name.substr(slash) + ".srv";
                if (service.empty() && emit::exists(file)) service = file;
            }
            if (service.empty() || options_.command == Command::Definition) {
                const Message* message = set_.message(name, {kName});
                if (message && options_.command == Command::Md5) out_ << md5Of(*message, set_) << "\n";
                if (message && options_.command == Command::Definition) out_ << definitionOf(*message, set_);
            } else if (const Service* found = set_.service(package, service)) {
                out_ << md5Of(*found, set_) << "\n";
            }
        }
    }

    /// Parses only: what the fields name need not be there.
    void dependencies() {
        const std::string& package = options_.words[0];
        std::vector<std::string> files(options_.words.begin() + 1, options_.words.end());
        if (files.empty() && !isKnown(package)) return;
        if (files.empty())
            for (const char* kind : kKinds)
                for (const std::string& file : filesOf(package, kind)) files.push_back(file);
        std::vector<Message> messages;
        for (const std::string& file : files) {
            const std::string text = emit::textOf(file), name = fs::path(file).stem().string();
            if (fs::path(file).extension() == ".srv") {
                const Service service = parseService(text, package, name, file, sink_);
                messages.insert(messages.end(), {service.request, service.response});
            } else {
                messages.push_back(parseMessage(text, package, name, file, sink_));
            }
        }
        std::vector<const Message*> all;
        for (const Message& message : messages) all.push_back(&message);
        for (const std::string& name : dependenciesOf(package, all)) out_ << name << "\n";
    }

    const RosOptions& options_;
    diag::Sink& sink_;
    std::ostream& out_;
    PackageSearch search_;
    MessageSet set_;
    ModelRules rules_;
};

bool tellOnly(const RosOptions& options, diag::Sink& sink, std::ostream& out) {
    if (options.command == Command::Help)
        out << rosUsage();
    else if (options.command == Command::Version)
        out << kName << " " << OROFORGE_VERSION << "\n";
    else if (options.command == Command::Explain)
        explain::explanations().print(options.words, {kName, "RM008"}, out, sink);
    else
        return false;
    return true;
}

}  // namespace

int runTypegenRos(const std::vector<std::string>& words, std::ostream& out, std::ostream& err) {
    const report::Format format = report::wantedFormat(words);
    diag::Sink sink;
    bool told = false;
    try {
        const auto options = parseRosOptions(words, sink);
        told = options && tellOnly(*options, sink, out);
        if (options && !told) Run(*options, sink, format == report::Format::Text ? out : err).run();
    } catch (const std::exception& failure) {
        sink.error({kName}, "RM009", std::string("stopped by a failure that was not expected: ") + failure.what());
    }
    const bool complete = told && !sink.hadErrors();
    const bool written =
        complete || report::write(format, {kName, OROFORGE_VERSION, &explain::explanations()}, sink, out, err);
    const bool arrived = diag::arrived(out, err, kName, "EMIT004");
    return !written || !arrived || sink.hadErrors() ? 1 : 0;
}

}  // namespace oroforge::messages
