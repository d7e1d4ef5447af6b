// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "typegen.hpp"

#include <exception>
#include <filesystem>
#include <ostream>
#include <set>
#include <sstream>

#include <adapters/read_adapters.hpp>
#include <clang/types/type_reader.hpp>
#include <collect/check_stamps.hpp>
#include <collect/close_model.hpp>
#include <collect/header_inputs.hpp>
#include <collect/import_package.hpp>
#include <diag/print.hpp>
#include <diff/compare_models.hpp>
#include <diff/tell_changes.hpp>
#include <emit/depfile.hpp>
#include <emit/outputs.hpp>
#include <flags/compile_database.hpp>
#include <flags/flags_file.hpp>
#include <messages/match_messages.hpp>
#include <plan/sources.hpp>
#include <plan/typekit_files.hpp>
#include <plan/typekit_view.hpp>
#include <explain/explanations.hpp>

#include "check_output.hpp"
#include "run_record.hpp"

namespace fs = std::filesystem;

namespace oroforge::embedded {
diag::EmbeddedFiles typekitTemplates();
}

namespace oroforge::typekit {

namespace {

void addDatabaseFlags(const Options& options, cxx::ParseRequest& request, diag::Sink& sink, std::ostream& out) {
    diag::Sink faultsOfInputs;  // reported where the inputs are read
    const auto headers = expandInputs(options.inputs, faultsOfInputs);
    const auto database = flags::readCompileDatabase(options.database, options.databaseEntry, headers, sink);
    if (!database) return;
    const auto flags = flags::withoutOverridden(database->flags, request.flags);
    request.flags.insert(request.flags.end(), flags.begin(), flags.end());
    if (options.verbose) out << "options of " << database->source << ", from " << database->file << "\n";
}

cxx::ParseRequest requestFor(const Options& options, diag::Sink& sink, std::ostream& out) {
    cxx::ParseRequest request;
    request.flags = options.flags;
    request.target = options.target;
    request.strict = options.strict;
    for (const std::string& package : options.imports) {
        const auto flags = importFlags(package, options.target, sink);
        request.flags.insert(request.flags.end(), flags.begin(), flags.end());
    }
    if (!options.flagsFile.empty()) {
        const auto flags = flags::readFlagsFile(options.flagsFile, sink);
        request.flags.insert(request.flags.end(), flags.begin(), flags.end());
    }
    if (!options.database.empty()) addDatabaseFlags(options, request, sink, out);
    request.headers = findHeaders(options.inputs, request.flags, options.name, sink);
    for (model::Header& header : request.headers) {
        const auto named = options.includeAs.find(header.path);
        if (named != options.includeAs.end()) header.include = named->second;
        const auto pieces = options.pieces.find(header.path);
        std::error_code error;
        const std::uintmax_t bytes = fs::file_size(header.path, error);
        header.pieces = pieces != options.pieces.end() ? pieces->second : error ? 1 : piecesFor(bytes);
    }
    return request;
}

std::optional<cxx::ParseRequest> makeRequest(const Options& options, diag::Sink& sink, std::ostream& out) {
    cxx::ParseRequest request = requestFor(options, sink, out);
    request.adapters = adapters::readAdapters(options.adapters, sink);
    if (sink.hadErrors()) return std::nullopt;
    return request;
}

std::optional<model::TypeModel> readModel(const Options& options, const cxx::ParseRequest& request, diag::Sink& sink) {
    auto model = cxx::readTypes(request, sink);
    if (model) model->files.insert(model->files.end(), options.adapters.begin(), options.adapters.end());
    if (model) closeModel(*model, sink);
    if (model) messages::matchMessages(*model, sink);
    if (model) checkStamps(*model, sink);
    if (sink.hadErrors()) return std::nullopt;
    return model;
}

std::string realPath(const std::string& path) {
    std::error_code error;
    // The compiler spells system headers with "..", which only the file system can resolve.
    const fs::path real = fs::weakly_canonical(path, error);
    return (error ? fs::absolute(path) : real).string();
}

/// Writes absolute names: ninja and make run in other folders than typegen, and read relative names from theirs.
bool writeDependencies(const Options& options, const model::TypeModel& model, diag::Sink& sink) {
    if (options.depfile.empty()) return true;
    const fs::path folder = fs::absolute(options.output).lexically_normal();
    std::vector<std::string> outputs;
    if (options.depfileTarget.empty()) {
        for (const std::string& name : outputNames(options.name, model.headers))
            outputs.push_back((folder / name).string());
    } else {
        outputs.push_back(options.depfileTarget);
    }
    std::set<std::string> inputs;
    for (const std::string& file : model.files) inputs.insert(realPath(file));
    if (!options.database.empty()) inputs.insert(realPath(flags::compileDatabaseFile(options.database)));
    return emit::writeDepfile(options.depfile, outputs, {inputs.begin(), inputs.end()}, sink);
}

void tell(const model::TypeModel& model, const emit::Written& written, const std::vector<std::string>& removed,
          std::ostream& out) {
    for (const model::Struct& type : model.structs) out << "struct " << type.name << "\n";
    for (const model::Adapted& type : model.adapted) out << "class " << type.name << "\n";
    for (const model::Enum& type : model.enums) out << "enum " << type.name << "\n";
    for (const diag::Note& note : model.notes)
        out << note.where.file << ":" << note.where.line << ":" << note.where.column << ": note: " << note.message
            << "\n";
    for (const std::string& file : written.changed) out << "wrote " << file << "\n";
    for (const std::string& file : written.unchanged) out << "unchanged " << file << "\n";
    for (const std::string& file : removed) out << "removed " << file << "\n";
}

int generate(const Options& options, const model::TypeModel& model, diag::Sink& sink, std::ostream& out) {
    const nlohmann::json view = makeView(model, options.name);
    if (options.dump == Dump::View) {
        out << view.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
        return 0;
    }
    render::Templates templates(embedded::typekitTemplates());
    if (!options.templateDir.empty() && !templates.overrideFrom(options.templateDir, sink)) return 1;
    emit::Outputs outputs;
    try {
        outputs = renderTypekit(view, render::Renderer(templates));
    } catch (const render::RenderError& error) {
        sink.error({"typegen"}, "TK007", std::string("a template does not fit: ") + error.what());
        return 1;
    }
    if (options.check) return checkOutput(outputs, options.output, options.refresh, sink) ? 0 : 1;
    emit::Written written;
    if (!emit::writeGenerated(outputs, options.output, sink, &written)) return 1;
    const std::vector<std::string> removed = removeSuperfluousSources(outputs, options.output);
    if (!writeDependencies(options, model, sink)) return 1;
    if (options.verbose) tell(model, written, removed, out);
    return 0;
}

int runDiff(const Options& options, diag::Sink& sink, std::ostream& out) {
    std::vector<model::TypeModel> versions;
    for (const std::string& input : options.inputs) {
        Options one = options;
        one.inputs = {input};
        const auto request = makeRequest(one, sink, out);
        auto model = request ? readModel(one, *request, sink) : std::nullopt;
        if (!model) return 1;
        versions.push_back(std::move(*model));
    }
    const std::vector<Change> changes = compareModels(versions[0], versions[1]);
    tellChanges(changes, sink);
    out << verdict(changes) << "\n";
    return sink.hadErrors() ? 1 : 0;
}

}  // namespace

int run(const Options& options, diag::Sink& sink, std::ostream& out) {
    if (options.diff) return runDiff(options, sink, out);
    if (options.listOutputs) {
        // A missing input is an error when it is needed; names can be listed without it.
        diag::Sink faults;
        emit::listOutputs(out, outputNames(options.name, requestFor(options, faults, out).headers), options.output);
        return 0;
    }
    const auto request = makeRequest(options, sink, out);
    if (!request) return 1;
    const RunRecord record(options, *request);
    const bool writes = options.dump == Dump::None && !options.check;
    if (writes && record.isCurrent()) {
        if (options.verbose) out << "up to date\n";
        return 0;
    }
    const auto model = readModel(options, *request, sink);
    if (!model) return 1;
    if (options.dump == Dump::Model) {
        out << dump(*model);
        return 0;
    }
    if (writes) record.forget();
    const int status = generate(options, *model, sink, out);
    // A run with warnings is not recorded, so that each run shows them.
    if (status == 0 && writes && sink.all().empty()) record.keep(model->files);
    return status;
}

namespace {

/// Prints what is asked for instead of a typekit; false if a typekit is wanted.
bool tellOnly(const Options& options, diag::Sink& sink, std::ostream& out) {
    if (options.help) {
        out << usage();
    } else if (options.version) {
        out << "typegen " << OROFORGE_VERSION << "\n";
    } else if (options.explain) {
        explain::explanations().print(options.codes, {"typegen", "TK003"}, out, sink);
    } else {
        return false;
    }
    return true;
}

}  // namespace

int run(const std::vector<std::string>& words, std::ostream& out, std::ostream& err) {
    const report::Format format = report::wantedFormat(words);
    const bool isText = format == report::Format::Text;
    diag::Sink sink;
    std::ostringstream last;  // the verdict of --diff goes below the changes
    bool told = false;
    try {
        const auto options = parseOptions(words, sink);
        told = options && tellOnly(*options, sink, out);
        // A document for programs has standard output to itself.
        if (options && !told) run(*options, sink, options->diff ? last : isText ? out : err);
    } catch (const std::exception& failure) {
        sink.error({"typegen"}, "TK009", std::string("stopped by a failure that was not expected: ") + failure.what());
    }
    const bool complete = told && !sink.hadErrors();
    const bool written =
        complete || report::write(format, {"typegen", OROFORGE_VERSION, &explain::explanations()}, sink, out, err);
    (isText ? out : err) << last.str();
    const bool arrived = diag::arrived(out, err, "typegen", "EMIT004");
    return !written || !arrived || sink.hadErrors() ? 1 : 0;
}

}  // namespace oroforge::typekit
